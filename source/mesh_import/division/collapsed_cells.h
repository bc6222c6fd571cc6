// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/mesh_file.h"

namespace Signorini
{
  /// Recognise degenerate elements: some programs write a wedge, a pyramid or a tetrahedron as a
  /// hexahedron with repeated corners, and a triangle as a quadrilateral. Such elements get the
  /// shape that they really have. Elements that are none of these are not changed.
  /// @param file the mesh whose elements are replaced
  /// @param elements indices of the elements to consider
  void
  recognise_collapsed_cells(MeshFile &file, const std::vector<unsigned int> &elements);
} // namespace Signorini
