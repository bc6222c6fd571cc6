// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/division/centers.h"

namespace Signorini
{
  /// Divide a pyramid, wedge or hexahedron into two, three or six tetrahedra, of second order if
  /// the cell is.
  ///
  /// Each face is divided by the diagonal at its corner with the lowest node number, so that
  /// neighbours agree; the tetrahedra are cones from the lowest corner of the cell over the
  /// triangles of the faces that do not contain it (J. Dompierre, P. Labbé, M.-G. Vallet, R.
  /// Camarero: How to subdivide pyramids, prisms, and hexahedra into tetrahedra, 8th International
  /// Meshing Roundtable 1999).
  /// @param cell the element; a tetrahedron is returned unchanged
  /// @param file the mesh, to which nodes of second order may be appended
  /// @param centers the nodes of second order
  /// @return the tetrahedra, with type and number of the cell
  std::vector<MeshFile::Element>
  tetrahedra_of(const MeshFile::Element &cell, MeshFile &file, Centers &centers);

  /// @return the two triangles into which this rule divides a quadrilateral.
  /// @param around its corners, in cyclic order
  std::vector<MeshFile::Nodes>
  triangles_of(const MeshFile::Nodes &around);
} // namespace Signorini
