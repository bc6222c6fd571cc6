// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/parameters/expression.h>

#include <vector>

namespace Signorini
{
  class Section;

  /// The load steps.
  struct LoadSteps
  {
    double       end_time = 1;
    unsigned int number   = 1;
    /// As many steps of any length as are needed.
    bool is_automatic = false;
    /// Ends of steps, of all of them unless these are automatic; empty: equal steps.
    std::vector<double> times;
    /// Times at which supports change, where steps end as well.
    std::vector<double> changes;
    unsigned int        cut_backs = 4;
    /// With friction, automatic steps are halved until that changes tangential tractions by less
    /// than this fraction.
    double path_error = 1e-2;

    /// @return the ends of all prescribed steps, increasing; for automatic ones the times, or the
    /// last end, and the changes.
    std::vector<double>
    ends() const;

    /// @return the length of the shortest step that is tried on the way to the end of a prescribed
    /// one.
    /// @param whole length of the prescribed step
    double
    shortest(double whole) const;

    /// @return the length of the next step.
    /// @param last the length of the step that was solved
    /// @param newton_steps number of Newton steps that it took
    /// @param so_far largest length that earlier steps have permitted
    double
    next_length(double last, unsigned int newton_steps, double so_far) const;

    /// Declare the keys and read their values. Throws SceneError.
    /// @param section `Load steps`
    void
    declare(Section &section);

  private:
    /// Interpret the number of steps, which may be `automatic`.
    void
    read_number(Section &section, const Formula &text);
  };
} // namespace Signorini
