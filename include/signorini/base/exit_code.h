// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace Signorini
{
  /// Exit codes of the program.
  enum ExitCode
  {
    solved         = 0,
    internal_error = 1,
    bad_scene      = 2, ///< or bad command line
    not_converged  = 3,
    missed         = 4, ///< solved, but an expected result of the scene is missed
    interrupted    = 5  ///< by a signal or its limit on time; --restart goes on
  };
} // namespace Signorini
