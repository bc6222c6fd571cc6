// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>

namespace Signorini
{
  /// The solution could not be computed. Thrown by all ranks alike.
  class SolverFailure : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };

  /// CG has found a direction of negative curvature: the system is not positive definite.
  class IndefiniteSystem : public SolverFailure
  {
  public:
    using SolverFailure::SolverFailure;
  };
} // namespace Signorini
