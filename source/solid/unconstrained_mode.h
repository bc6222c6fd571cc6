// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "linear_algebra/types.h"

#include <string>

namespace Signorini
{
  /// A rigid-body mode that no support constrains.
  struct UnconstrainedMode
  {
    std::string name;   ///< "ball: translation z"
    LA::Vector  motion; ///< displacement; zero at constrained degrees of freedom
  };
} // namespace Signorini
