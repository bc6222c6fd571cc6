// SPDX-License-Identifier: Apache-2.0
#include "driver/path_control.h"

#include <algorithm>
#include <cmath>

namespace Signorini
{
  PathControl::PathControl(const double tolerance)
    : tolerance(tolerance)
  {}



  PathControl::Size
  PathControl::distance(const Solution &one, const Solution &other)
  {
    const auto &a = one.tractions, &b = other.tractions;
    Size        result;
    for (unsigned int k = 0; k < std::max(a.size(), b.size()); ++k)
      {
        LA::Vector difference = k < a.size() ? a[k] : b[k];
        if (k < a.size() && k < b.size())
          difference -= b[k];
        result.tractions += difference.l1_norm();
      }
    result.work = std::abs(one.work - other.work);
    return result;
  }



  bool
  PathControl::judge(const Solution &before, const Solution &coarse, const Solution &fine)
  {
    const Size size = distance(fine, {}), error = distance(fine, coarse),
               change = distance(fine, before);
    Size &largest = my_budget.largest, &spent = my_budget.spent;
    largest.tractions               = std::max(largest.tractions, size.tractions);
    largest.work                    = std::max({largest.work, size.work, fine.negligible_work});
    my_error                        = 0;
    my_growth                       = 2;
    const bool traction_is_accurate = judge(
      error.tractions, change.tractions, largest.tractions, spent.tractions, excess.tractions);
    const bool work_is_accurate =
      judge(error.work, change.work, largest.work, spent.work, excess.work);
    // A coefficient is that of the slip before the load step, in the whole step as in its halves.
    const double of_bound = fine.change_of_friction;
    if (of_bound > 0)
      my_growth = std::min(my_growth, std::max(1., 0.9 * tolerance / of_bound));
    return work_is_accurate && traction_is_accurate && of_bound <= tolerance;
  }



  void
  PathControl::accept()
  {
    my_budget.spent.tractions += excess.tractions;
    my_budget.spent.work += excess.work;
  }



  // (2.29). A load step may use up a fiftieth of what is left of the half of the tolerance that
  // does not depend on changes.
  bool
  PathControl::judge(const double error,
                     const double change,
                     const double largest,
                     const double spent,
                     double      &excess)
  {
    constexpr double half = 0.5, of_rest = 0.02, safety = 0.9;
    excess = 0;
    if (error == 0)
      return true;
    const double of_change = half * tolerance * change,
                 allowed   = std::max(of_change, of_rest * (half * tolerance * largest - spent));
    if (error > of_change)
      excess = error;
    my_error = std::max(my_error, error / largest);
    // Errors grow with the square of the length, what is allowed at most with its first power.
    my_growth = std::min(my_growth, std::max(1., safety * std::sqrt(allowed / error)));
    return error <= allowed;
  }
} // namespace Signorini
