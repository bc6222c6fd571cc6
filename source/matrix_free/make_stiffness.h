// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/elasticity.h"
#include "solid/stiffness.h"

#include <memory>
#include <optional>

namespace Signorini
{
  /// The form that is asked for, or the quicker one: without a matrix in space, where there are
  /// coarser levels (bodies of degree two, or cells that were refined), and nobody needs the matrix
  /// anyway. Throws SceneError if there is no code for what is asked for.
  /// @param is_to_be_refined the mesh in question is not the present one, but one that it becomes
  template <int dim>
  StiffnessForm
  choose_form(const std::optional<StiffnessForm> &wanted,
              bool                                needs_matrix,
              const Elasticity<dim>              &elasticity,
              bool                                is_to_be_refined = false);

  /// K on the present mesh. Refers to the elasticity. Collective.
  template <int dim>
  std::unique_ptr<const Stiffness>
  make_stiffness(StiffnessForm form, Elasticity<dim> &elasticity);
} // namespace Signorini
