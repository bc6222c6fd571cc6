// SPDX-License-Identifier: Apache-2.0
#include <signorini/parameters/section.h>
#include <signorini/parameters/time_span.h>

namespace Signorini
{
  void
  TimeSpan::declare_times(Section &section, const std::string &what)
  {
    section.add("Start time",
                from,
                what + " is active after this time, at which a load step ends; 0: from the start",
                non_negative);
    section.add("End time",
                until,
                what + " is removed after this time, at which a load step ends; 0: never",
                non_negative);
    if (section.reading() && until > 0 && until <= from)
      section.fail("End time", "must be later than Start time, or 0: it is never removed");
  }



  // Times are compared to 1e-10: ends of load steps, which are sums, count as the times of the
  // scene.
  bool
  TimeSpan::acts(const double t) const
  {
    // The half-open interval (from, until], because a load step is the solution at its end.
    constexpr double rounding = 1e-10;
    return (from == 0 || t > from * (1 + rounding)) && (until == 0 || t <= until * (1 + rounding));
  }
} // namespace Signorini
