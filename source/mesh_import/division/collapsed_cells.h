// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/mesh_file.h"

namespace Signorini
{
  /// Some programs write a wedge, a pyramid or a tetrahedron as a hexahedron whose corners are
  /// there several times, and a triangle as a quadrilateral. Give such elements the shape that they
  /// have. What is none of these stays as it is.
  /// @param elements indices of those that are looked at
  void
  recognise_collapsed_cells(MeshFile &file, const std::vector<unsigned int> &elements);
} // namespace Signorini
