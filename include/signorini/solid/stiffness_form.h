// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/parameters/choices.h>

namespace Signorini
{
  /// How products with K are made.
  enum class StiffnessForm
  {
    assembled,  ///< from a matrix
    matrix_free ///< from the cells, each time
  };

  // As the scene file calls them.

  const Choices<StiffnessForm> &
  stiffness_forms();
} // namespace Signorini
