// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "accuracy/quantity.h"

#include <vector>

namespace Signorini
{
  /// @return dJ/dp per area as a nodal field of a pair, with ghost values; zero for quantities with
  /// a lift, since their derivative by pressure belongs to the lift. Collective.
  template <int dim>
  LA::Vector
  by_pressure(const Snapshot<dim> &snapshot, const Functional &functional, unsigned int pair);

  /// @return the recovered tangential traction of a pair, component by component, with ghost
  /// values; empty for laws without it. Collective.
  template <int dim>
  std::vector<LA::Vector>
  recovered_traction(const Snapshot<dim> &snapshot, unsigned int pair);

  /// @return a vector field at a contact point; zero if it has no components.
  template <int dim>
  dealii::Tensor<1, dim>
  vector_at(const ContactSurface<dim>     &surface,
            const ContactPoint<dim>       &point,
            const std::vector<LA::Vector> &components);

  /// Errors of the traction at some contact points of a pair, exact minus computed.
  template <int dim>
  struct TractionErrors
  {
    std::vector<unsigned int>           points; ///< their numbers on the surface
    std::vector<double>                 pressure;
    std::vector<dealii::Tensor<1, dim>> tangential; ///< in space; empty for laws without it
  };

  /// Add the sum of omega . q dA over points to the cells of their faces, where omega is felt by
  /// tractions, by the pressure B z + dJ/dp, and q is the error of the traction. Collective.
  /// @param z the dual displacement, without the lift of the quantity
  template <int dim>
  void
  add_traction_errors(const Snapshot<dim>       &snapshot,
                      const Functional          &functional,
                      const LA::Vector          &z,
                      unsigned int               pair,
                      const TractionErrors<dim> &errors,
                      std::vector<double>       &of_cells);
} // namespace Signorini
