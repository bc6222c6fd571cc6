// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/mesh_file.h"

namespace Signorini
{
  /// Divide triangles into three quadrilaterals, tetrahedra into four and wedges into six
  /// hexahedra, at the middles of their edges and the centres of faces and cells; and likewise,
  /// into four or eight, the quadrilaterals or hexahedra that are connected with them by edges. A
  /// pyramid cannot be divided in this way, because four edges meet at its apex: it and all cells
  /// connected with it by quadrilaterals are divided into tetrahedra first. Connected pieces that
  /// consist of quadrilaterals or hexahedra alone are not changed.
  ///
  /// Neighbours share all nodes. Cells of second order become cells of 9 or 27 nodes that have
  /// exactly the same shape, straight ones become cells of 4 or 8 nodes. Children have the type and
  /// number of their element. Groups of cells contain the children; node sets get the new nodes
  /// that lie between nodes in them; `whole_faces` says of which face in the file each boundary
  /// face is a part, so that boundaries keep their faces. Throws SceneError, without the file's
  /// name, if cells are folded or flat.
  /// @param file the mesh, which is changed
  /// @param dim 2 or 3
  /// @param part the group whose cells these are; empty: all cells
  /// @param mid_side_nodes false: move mid-side nodes of divided cells to the positions that the
  /// corners alone determine
  /// @return messages for the user: what was divided, and the worst cells; none if nothing had to
  /// be divided
  std::vector<std::string>
  divide_cells(MeshFile &file, unsigned int dim, const std::string &part, bool mid_side_nodes);
} // namespace Signorini
