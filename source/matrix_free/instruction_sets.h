// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace Signorini
{
  /// The instruction sets of this processor for which there is code, fastest first.
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
