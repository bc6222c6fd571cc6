// SPDX-License-Identifier: Apache-2.0
#include "matrix_free/instruction_sets.h"

#include "matrix_free/targets.h"
#include <signorini/parameters/raw.h>

#include <hwy/highway.h>

#include <algorithm>
#include <cstdlib>

namespace Signorini
{
  namespace
  {
    /// The instruction set that the environment variable SIGNORINI_INSTRUCTION_SET selects; empty:
    /// none. Throws SceneError if it is not available.
    std::string
    set_of_environment()
    {
      const char       *value = std::getenv("SIGNORINI_INSTRUCTION_SET");
      const std::string name  = value ? value : "";
      const auto        known = instruction_sets();
      if (name.empty() || std::find(known.begin(), known.end(), name) != known.end())
        return name;
      std::string list;
      for (const std::string &one : known)
        list += " " + one;
      throw SceneError("SIGNORINI_INSTRUCTION_SET = " + name + ": this processor and program have" +
                       list);
    }
  } // namespace



  std::vector<std::string>
  instruction_sets()
  {
    std::vector<std::string> names;
    for (const auto target : hwy::SupportedAndGeneratedTargets())
      names.push_back(hwy::TargetName(target));
    return names;
  }



  ForcedInstructionSet::ForcedInstructionSet(const std::string &asked_for)
  {
    const std::string name = asked_for.empty() ? set_of_environment() : asked_for;
    if (!name.empty())
      for (const auto target : hwy::SupportedAndGeneratedTargets())
        // The choice is made in the static state of Highway, which the next dynamic dispatch reads;
        // the destructor returns to automatic choice.
        if (hwy::TargetName(target) == name)
          hwy::SetSupportedTargetsForTest(target);
  }



  ForcedInstructionSet::~ForcedInstructionSet()
  {
    hwy::SetSupportedTargetsForTest(0);
  }
} // namespace Signorini
