// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace Signorini
{
  /// The instruction sets of this processor for which there is code, fastest first.
  std::vector<std::string>
  instruction_sets();

  /// Restricts Highway's choice to one instruction set during its lifetime: the one named, or that
  /// of the environment variable SIGNORINI_INSTRUCTION_SET; no restriction if both are empty.
  /// Throws SceneError if there is no such set.
  class ForcedInstructionSet
  {
  public:
    explicit ForcedInstructionSet(const std::string &asked_for);

    ForcedInstructionSet(const ForcedInstructionSet &) = delete;

    ~ForcedInstructionSet();
  };
} // namespace Signorini
