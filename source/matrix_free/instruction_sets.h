// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace Signorini
{
  /// Those of this processor that there is code for, best first.
  std::vector<std::string>
  instruction_sets();

  /// Highway's choice, narrowed to one set while there is such an object: that of a name, or of the
  /// environment's SIGNORINI_INSTRUCTION_SET; the best one if both are empty. Throws SceneError if
  /// there is no such set.
  class ForcedInstructionSet
  {
  public:
    explicit ForcedInstructionSet(const std::string &asked_for);

    ForcedInstructionSet(const ForcedInstructionSet &) = delete;

    ~ForcedInstructionSet();
  };
} // namespace Signorini
