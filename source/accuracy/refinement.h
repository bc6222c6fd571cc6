// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/elasticity.h"
#include <signorini/accuracy/refinement_settings.h>

#include <vector>

namespace Signorini
{
  /// Mark the shares of the cells with the largest and least errors, or all. Collective.
  /// @param errors of each active cell, of this rank's own
  template <int dim>
  void
  mark_cells(const RefinementSettings  &settings,
             Mesh<dim>                 &mesh,
             const std::vector<double> &errors);

  /// Mark the least cells that have this share of the sum of all indicators, and those for
  /// coarsening that have next to nothing of it. Collective.
  template <int dim>
  void
  mark_share(const RefinementSettings  &settings,
             Mesh<dim>                 &mesh,
             const std::vector<double> &indicators,
             double                     share);

  /// The number of cells that the marked mesh will have, about, over that which it has. Collective.
  template <int dim>
  double
  growth(const Mesh<dim> &mesh);

  /// Take all marks off.
  template <int dim>
  void
  clear_marks(Mesh<dim> &mesh);

  /// Refine the mesh as it is marked, set the degrees of freedom up again, and carry vectors over:
  /// each goes in as it was and comes out interpolated. Collective.
  template <int dim>
  void
  refine(Mesh<dim> &mesh, Elasticity<dim> &elasticity, const std::vector<LA::Vector *> &vectors);
} // namespace Signorini
