// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace Signorini
{
  class Section;

  /// Load steps that have bars, and meet the targets.
  enum class JudgedSteps
  {
    all,
    last
  };

  /// What a user wants to know, and how accurately.
  struct Goals
  {
    std::vector<std::string> quantities; ///< see QuantityName
    std::vector<double>      targets;    ///< of relative errors, one a quantity; empty: none
    JudgedSteps              steps      = JudgedSteps::all; ///< where there are targets
    double                   time_limit = 0;                ///< minutes of wall time; 0: none

    bool
    has_targets() const
    {
      return !targets.empty();
    }

    /// Have load steps before the last one bars of their own?
    bool
    judge_all_steps() const
    {
      return has_targets() && steps == JudgedSteps::all;
    }

    void
    declare(Section &section);
  };
} // namespace Signorini
