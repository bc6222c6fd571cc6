// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/parameters/choices.h>

namespace Signorini
{
  /// The form in which products with K are evaluated.
  enum class StiffnessForm
  {
    /// By an assembled matrix.
    assembled,
    /// Cell by cell in each product.
    matrix_free
  };

  /// The forms by the names that the scene file uses.

  const Choices<StiffnessForm> &
  stiffness_forms();
} // namespace Signorini
