// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/elasticity.h"
#include "solid/stiffness.h"

#include <memory>
#include <optional>

namespace Signorini
{
  /// The wanted form of the stiffness, or the faster one: matrix-free in space if there are coarser
  /// levels (degree two, or refined cells) or nonlinear bodies and the matrix is not needed
  /// otherwise. Throws SceneError if the wanted form is not available.
  /// @param needs_matrix the preconditioner needs the assembled matrix
  /// @param is_to_be_refined the choice is for a mesh that will be refined from the present one
  template <int dim>
  StiffnessForm
  choose_form(const std::optional<StiffnessForm> &wanted,
              bool                                needs_matrix,
              const Elasticity<dim>              &elasticity,
              bool                                is_to_be_refined = false);

  /// Make the stiffness K on the present mesh. Refers to the elasticity. Collective.
  template <int dim>
  std::unique_ptr<const Stiffness>
  make_stiffness(StiffnessForm form, Elasticity<dim> &elasticity);
} // namespace Signorini
