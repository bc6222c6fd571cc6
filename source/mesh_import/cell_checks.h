// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/mesh_file.h"

#include <deal.II/grid/tria_description.h>

namespace Signorini
{
  /// Reverse cells whose nodes are listed with negative orientation. Throws SceneError with the
  /// number of cells that are folded or flat, and with the element and the corner of the first.
  /// @param cells the cells, which are changed
  /// @param vertices to which they refer
  /// @param elements the element of each cell, for the message
  template <int dim>
  void
  orient(std::vector<dealii::CellData<dim>>           &cells,
         const std::vector<dealii::Point<dim>>        &vertices,
         const std::vector<const MeshFile::Element *> &elements);
} // namespace Signorini
