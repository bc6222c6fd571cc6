// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/division/centers.h"

namespace Signorini
{
  /// Divide a pyramid, wedge or hexahedron into two, three or six tetrahedra, of second order if
  /// the cell is.
  ///
  /// Of each face, and of the cell, the corner with the lowest number sees all the rest: faces are
  /// divided by the diagonal at their lowest corner, so that neighbours agree, and the tetrahedra
  /// stand on the triangles of the faces that the cell's lowest corner does not belong to
  /// (J. Dompierre, P. Labbé, M.-G. Vallet, R. Camarero: How to subdivide pyramids, prisms, and
  /// hexahedra into tetrahedra, 8th International Meshing Roundtable 1999).
  std::vector<MeshFile::Element>
  tetrahedra_of(const MeshFile::Element &cell, MeshFile &file, Centers &centers);

  /// The two triangles of a quadrilateral, around, that this makes.
  std::vector<MeshFile::Nodes>
  triangles_of(const MeshFile::Nodes &around);
} // namespace Signorini
