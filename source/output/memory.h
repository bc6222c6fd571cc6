// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace Signorini
{
  /// What the machine could give to programs, in kB; infinite if it does not tell.
  double
  available_memory();
} // namespace Signorini
