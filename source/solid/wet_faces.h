// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/solid/boundary_conditions.h>

#include <deal.II/grid/cell_id.h>
#include <deal.II/grid/tria_accessor.h>

#include <set>
#include <utility>

namespace Signorini
{
  /// The faces on which the fluid of a load acts: cells of this rank, and numbers of their faces.
  struct WetFaces
  {
    std::set<std::pair<dealii::CellId, unsigned int>> faces;
  };

  /// True if the pressure of a load acts on a face of its boundaries.
  /// @param cell of the mesh, or of a DoFHandler on it
  template <int dim>
  bool
  pressure_acts(const Load<dim>                 &load,
                const dealii::CellAccessor<dim> &cell,
                const unsigned int               face)
  {
    return !load.wet || load.wet->faces.count({cell.id(), face}) > 0;
  }
} // namespace Signorini
