// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/elasticity.h"
#include "solid/stiffness.h"

#include <memory>
#include <optional>

namespace Signorini
{
  /// The wanted form of the stiffness, or the faster one: matrix-free in space, except for
  /// tetrahedra of degree one at small strain, if the matrix is not needed otherwise. Throws
  /// SceneError if the wanted form is not available.
  /// @param needs_matrix the preconditioner needs the assembled matrix
  template <int dim>
  StiffnessForm
  choose_form(const std::optional<StiffnessForm> &wanted,
              bool                                needs_matrix,
              const Elasticity<dim>              &elasticity);

  /// Make the stiffness K on the present mesh. Refers to the elasticity. Collective.
  template <int dim>
  std::unique_ptr<const Stiffness>
  make_stiffness(StiffnessForm form, Elasticity<dim> &elasticity);
} // namespace Signorini
