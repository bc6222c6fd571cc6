// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/elasticity.h"

namespace Signorini
{
  /// Choose the bodies for which quadratic elements are more efficient than smaller ones.
  /// Collective.
  ///
  /// On meshes adapted to a quantity its error decreases as N^(-2/dim) with degree 1, and as
  /// N^(-4/dim) with degree 2 (doc/benchmarks/accuracy.md). To divide it by `excess_error`, degree
  /// 1 takes N excess^(dim/2) degrees of freedom; degree 2 has 2^dim N of them on the same cells,
  /// each about twice as expensive.
  /// @param mesh the mesh
  /// @param indicators of the active cells, in units of what their sum may be
  /// @param is_open for each body whether its degree is 1 and may be raised
  /// @param excess_error factor by which the error is too large
  /// @return indices of bodies, in ascending order
  template <int dim>
  std::vector<unsigned int>
  bodies_to_p_refine(const Mesh<dim>           &mesh,
                     const std::vector<double> &indicators,
                     const std::vector<bool>   &is_open,
                     double                     excess_error);

  /// @return the factor by which the number of degrees of freedom grows if some bodies become
  /// quadratic. Collective.
  /// @param mesh the mesh
  /// @param bodies their indices
  template <int dim>
  double
  growth_of_p_refinement(const Mesh<dim> &mesh, const std::vector<unsigned int> &bodies);

  /// @return the same displacement in a space of higher degree on the same cells. Collective.
  /// @param elasticity the present space
  /// @param displacement in that space
  /// @param richer the space of higher degree
  template <int dim>
  LA::Vector
  p_refined(const Elasticity<dim> &elasticity,
            const LA::Vector      &displacement,
            const Elasticity<dim> &richer);
} // namespace Signorini
