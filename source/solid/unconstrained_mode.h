// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "linear_algebra/types.h"

#include <string>

namespace Signorini
{
  /// A motion without deformation that no support holds.
  struct UnconstrainedMode
  {
    std::string name;   ///< "ball: translation z"
    LA::Vector  motion; ///< of free degrees of freedom; zero at constrained ones
  };
} // namespace Signorini
