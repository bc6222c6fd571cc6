// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/mesh_file.h"

namespace Signorini
{
  /// Divide triangles into three quadrilaterals, tetrahedra into four and wedges into six
  /// hexahedra, at the middles of their edges and the centers of faces and cells; and so, into four
  /// or eight, the quadrilaterals or hexahedra that are connected with them by edges. A pyramid
  /// cannot be divided so, because four edges meet at its apex: it and all that is connected with
  /// it by quadrilaterals are divided into tetrahedra first. Pieces of quadrilaterals or hexahedra
  /// alone stay as they are.
  ///
  /// Neighbours share all nodes. Cells of second order become cells of 9 or 27 nodes that have
  /// exactly the same shape, straight ones of 4 or 8 nodes. Children have type and number of their
  /// element. Parts keep their cells; node sets get the new nodes that lie between nodes in them;
  /// `whole_faces` says of which face in the file each boundary face is a part, so that boundaries
  /// keep their faces.
  /// @param part the group whose cells these are; empty: all cells
  /// @param mid_side_nodes false: move mid-side nodes of divided cells to where the corners alone
  /// put them
  /// @return what the user may want to know: what was divided, and the worst cells
  /// Throws SceneError, without the file's name, if cells are folded or flat.
  std::vector<std::string>
  divide_cells(MeshFile &file, unsigned int dim, const std::string &part, bool mid_side_nodes);
} // namespace Signorini
