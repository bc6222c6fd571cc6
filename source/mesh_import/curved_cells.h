// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/mesh_file.h"

#include <deal.II/grid/tria.h>

namespace Signorini
{
  /// Cells of second order take the shape that their mid-side nodes give them: those that are not
  /// straight get a manifold each, and their faces and lines that of one of their cells, with which
  /// the others agree there.
  /// @param elements the element of each cell of the triangulation
  /// @param first manifold id; the others follow
  /// @return the number of such cells
  /// Throws SceneError with the element if such a cell is folded.
  template <int dim>
  unsigned int
  curve_cells(dealii::Triangulation<dim>                   &triangulation,
              const MeshFile                               &file,
              const std::vector<const MeshFile::Element *> &elements,
              dealii::types::manifold_id                    first);
} // namespace Signorini
