// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace Signorini
{
  class Section;

  /// The load steps that have error bounds and must meet the targets.
  enum class JudgedSteps
  {
    all,
    last
  };

  /// The quantities of interest of a scene, and how accurate they are to be.
  struct Goals
  {
    /// Names of the quantities, see QuantityName.
    std::vector<std::string> quantities;
    /// Relative error bounds, one for each quantity; empty: none.
    std::vector<double> targets;
    /// The load steps for which the targets hold.
    JudgedSteps steps = JudgedSteps::all;
    /// Limit of refinement [minutes of wall time]; 0: none.
    double time_limit = 0;

    /// @return whether there are targets.
    bool
    has_targets() const
    {
      return !targets.empty();
    }

    /// @return whether load steps before the last one have error bounds of their own.
    bool
    judge_all_steps() const
    {
      return !quantities.empty() && steps == JudgedSteps::all;
    }

    /// Declare the keys and read their values. Throws SceneError if targets are too small, or do
    /// not match the quantities.
    /// @param section `Accuracy`
    void
    declare(Section &section);
  };
} // namespace Signorini
