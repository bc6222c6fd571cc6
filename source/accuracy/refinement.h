// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/elasticity.h"
#include <signorini/accuracy/refinement_settings.h>

#include <vector>

namespace Signorini
{
  /// Mark fixed fractions of the cells with the largest and smallest errors for refinement and
  /// coarsening, or all cells. Collective.
  /// @param settings with the fractions
  /// @param mesh whose cells are marked
  /// @param errors one for each active cell; those of locally owned cells are used
  template <int dim>
  void
  mark_cells(const RefinementSettings  &settings,
             Mesh<dim>                 &mesh,
             const std::vector<double> &errors);

  /// Mark the smallest set of cells that has a share of the sum of all indicators for refinement,
  /// and cells with a negligible share for coarsening. Collective.
  /// @param settings with the strategy
  /// @param mesh whose cells are marked
  /// @param indicators one for each active cell; those of locally owned cells are used
  /// @param share between 0 and 1
  template <int dim>
  void
  mark_share(const RefinementSettings  &settings,
             Mesh<dim>                 &mesh,
             const std::vector<double> &indicators,
             double                     share);

  /// @return the approximate ratio of the number of cells after refinement, as marked, to the
  /// present number. Collective.
  /// @param mesh with marked cells
  template <int dim>
  double
  growth(const Mesh<dim> &mesh);

  /// Remove all marks of cells.
  /// @param mesh whose cells are marked
  template <int dim>
  void
  clear_marks(Mesh<dim> &mesh);

  /// Refine the mesh as it is marked, distribute the degrees of freedom anew, and interpolate
  /// vectors. Collective.
  /// @param mesh with marked cells; cells are not coarsened below the least level of their body
  /// @param elasticity of the mesh
  /// @param vectors which are replaced by their interpolants
  template <int dim>
  void
  refine(Mesh<dim> &mesh, Elasticity<dim> &elasticity, const std::vector<LA::Vector *> &vectors);
} // namespace Signorini
