// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace Signorini
{
  /// @return the memory [kB] of the machine that is available to programs; infinite if it is
  /// unknown.
  double
  available_memory();
} // namespace Signorini
