// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>

namespace Signorini
{
  /// The solution could not be found. All ranks throw it alike.
  class SolverFailure : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };

  /// CG has met a direction along which the system is not positive.
  class IndefiniteSystem : public SolverFailure
  {
  public:
    using SolverFailure::SolverFailure;
  };
} // namespace Signorini
