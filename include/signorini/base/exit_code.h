// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace Signorini
{
  /// Exit codes of the program.
  enum ExitCode
  {
    solved         = 0,
    internal_error = 1,
    /// The scene or the command line is not valid.
    bad_scene     = 2,
    not_converged = 3,
    /// Solved, but an expected result of the scene is not met.
    missed = 4,
    /// Interrupted by a signal or the time limit; --restart continues the run.
    interrupted = 5
  };
} // namespace Signorini
