// SPDX-License-Identifier: Apache-2.0
#include "parameters/values.h"
#include <signorini/parameters/section.h>
#include <signorini/scene/load_steps.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  namespace
  {
    /// @return whether two times are equal up to rounding.
    bool
    are_one(const double t, const double other)
    {
      return std::abs(t - other) <= 1e-10 * std::abs(other);
    }
  } // namespace



  void
  LoadSteps::read_number(Section &section, const Formula &text)
  {
    is_automatic = text.text == "automatic";
    if (is_automatic)
      return;
    try
      {
        from_text(text, number);
      }
    catch (const SceneError &error)
      {
        section.fail("Number", std::string(error.what()) + "; or write automatic");
      }
    if (number < 1 || number > 1e6)
      section.fail("Number", "must be in [1, 1000000], or automatic");
  }



  // Times, if given, replace End time and a number.
  void
  LoadSteps::declare(Section &section)
  {
    section.add(
      "End time",
      end_time,
      "end of the load history, which starts at t = 0; supports, loads and obstacles depend on t",
      positive);
    Formula steps = is_automatic ? "automatic" : to_text(number);
    section.add(
      "Number",
      steps,
      "number of equal load steps, [1, 1000000]; automatic: one step, and if it does not converge, "
      "steps whose size is controlled by the number of iterations; with friction at least eight "
      "steps, and as many as the Path error asks for");
    if (section.reading())
      read_number(section, steps);
    section.add(
      "Times",
      times,
      "end times of the load steps, increasing, instead of End time and Number; with Number = "
      "automatic more load steps are taken between them");
    section.add(
      "Cut-backs",
      cut_backs,
      "number of times that a load step may be halved if it does not converge; later steps grow "
      "again; at least 10 for Number = automatic",
      Range{0, 20});
    section.add(
      "Path error",
      path_error,
      "with friction and Number = automatic: tolerance of the error of tangential tractions due to "
      "the length of the load steps, relative to the largest ones; each load step is repeated as "
      "two of half the length, and halved until the changes by that, summed over all load steps, "
      "are expected to be smaller than this",
      positive);
    for (unsigned int i = 0; i < times.size(); ++i)
      if (times[i] <= (i > 0 ? times[i - 1] : 0))
        section.fail("Times", "must be positive and increasing");
    if (section.reading() && !times.empty())
      {
        end_time = times.back();
        number   = times.size();
      }
  }



  // Changes of supports are ends of load steps too, unless they coincide with one.
  std::vector<double>
  LoadSteps::ends() const
  {
    // The steps that the scene asks for.
    std::vector<double> result = times;
    if (times.empty() && is_automatic)
      result = {end_time};
    else if (times.empty())
      for (unsigned int step = 1; step <= number; ++step)
        result.push_back(end_time * step / number);
    for (const double t : changes)
      {
        // A change in between divides its step. Changes after the end of the history have no
        // effect.
        const auto next = std::lower_bound(result.begin(), result.end(), t);
        if (next != result.end() && !are_one(*next, t) &&
            (next == result.begin() || !are_one(*(next - 1), t)))
          result.insert(next, t);
      }
    return result;
  }



  // Each cut-back halves the step.
  double
  LoadSteps::shortest(const double whole) const
  {
    constexpr unsigned int least = 10;
    return whole / std::pow(2, is_automatic ? std::max(cut_backs, least) : cut_backs);
  }



  // A step that converged may be followed by one twice as long, unless an automatic step took many
  // Newton iterations.
  double
  LoadSteps::next_length(const double       last,
                         const unsigned int newton_steps,
                         const double       so_far) const
  {
    constexpr unsigned int few = 15; // a step twice as long mostly takes less than twice of them
    return is_automatic && newton_steps > few ? std::min(so_far, last) : std::max(so_far, 2 * last);
  }
} // namespace Signorini
