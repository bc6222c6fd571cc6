// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/elasticity.h"

namespace Signorini
{
  /// The bodies for which quadratic elements are worth more than smaller ones.
  ///
  /// On meshes for a quantity its error falls as N^(-2/dim) with degree 1, and as N^(-4/dim) with
  /// degree 2 (doc/benchmarks/accuracy.md). To divide it by `excess_error`, degree 1 takes N
  /// excess^(dim/2) degrees of freedom; degree 2 has 2^dim N of them on the same cells, each about
  /// twice as expensive.
  ///
  /// @param indicators of the cells, in units of what their sum may be
  /// @param is_open bodies whose degree is 1 and may be raised
  /// @param excess_error by what the error is too large
  /// Collective.
  template <int dim>
  std::vector<unsigned int>
  bodies_to_p_refine(const Mesh<dim>           &mesh,
                     const std::vector<double> &indicators,
                     const std::vector<bool>   &is_open,
                     double                     excess_error);

  /// By what the number of degrees of freedom grows if these bodies become quadratic. Collective.
  template <int dim>
  double
  growth_of_p_refinement(const Mesh<dim> &mesh, const std::vector<unsigned int> &bodies);

  /// The same displacement in a space of higher degree on the same cells.
  template <int dim>
  LA::Vector
  p_refined(const Elasticity<dim> &elasticity,
            const LA::Vector      &displacement,
            const Elasticity<dim> &richer);
} // namespace Signorini
