// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace Signorini
{
  class Section;

  /// The time during which a part of a scene acts, which ends of load steps bound.
  struct TimeSpan
  {
    /// It acts at later times; 0: also at the start.
    double from = 0;
    /// It acts up to this time; 0: to the end.
    double until = 0;

    /// True if it acts at time t. A time that equals an end of the span up to rounding counts as
    /// that end.
    bool
    acts(double t) const;

    /// True if there is a time at which it does not act.
    bool
    is_limited() const
    {
      return from > 0 || until > 0;
    }

    /// True if there is a time at which both act.
    bool
    overlaps(const TimeSpan &other) const
    {
      return (until == 0 || other.from < until) && (other.until == 0 || from < other.until);
    }

    /// Declare the keys `Start time` and `End time`. @param what the part, as in "the support"
    void
    declare_times(Section &section, const std::string &what);
  };
} // namespace Signorini
