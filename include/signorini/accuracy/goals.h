#pragma once

#include <string>
#include <vector>

namespace Signorini
{
  class Section;

  /// What a user wants to know, and how accurately.
  struct Goals
  {
    std::vector<std::string> quantities;     ///< see QuantityName
    std::vector<double>      targets;        ///< of relative errors, one a quantity; empty: none
    double                   time_limit = 0; ///< minutes of wall time; 0: none

    bool
    has_targets() const
    {
      return !targets.empty();
    }

    void
    declare(Section &section);
  };
} // namespace Signorini
