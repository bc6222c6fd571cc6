// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/parameters/expression.h>

#include <vector>

namespace Signorini
{
  class Section;

  /// The history of loading.
  struct LoadSteps
  {
    double              end_time     = 1;
    unsigned int        number       = 1;
    bool                is_automatic = false; ///< as many as are needed, of any length
    std::vector<double> times;                ///< instead of equal steps
    std::vector<double> changes;              ///< at which steps end too: of supports
    unsigned int        cut_backs = 4;

    /// The ends of all steps that are asked for; of automatic ones the last, and the changes.
    std::vector<double>
    ends() const;

    /// The shortest step that is tried on the way to the end of one that is so long.
    double
    shortest(double whole) const;

    /// Of the next step.
    /// @param last the length of the one that was solved
    /// @param newton_steps that it took
    /// @param so_far what it may be for what was before
    double
    next_length(double last, unsigned int newton_steps, double so_far) const;

    void
    declare(Section &section);

  private:
    void
    read_number(Section &section, const Formula &text);
  };
} // namespace Signorini
