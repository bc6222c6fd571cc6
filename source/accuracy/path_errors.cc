// SPDX-License-Identifier: Apache-2.0
#include "accuracy/path_errors.h"

#include <algorithm>
#include <cmath>

namespace Signorini
{
  namespace
  {
    /// @return the factor by which changes decrease, the geometric mean since the largest one:
    /// values jump as points change from stick to slip, so that a single ratio may be chance. One,
    /// if they do not decrease yet.
    double
    mean_ratio(const std::vector<double> &changes)
    {
      const auto largest = std::max_element(changes.begin(), changes.end());
      const auto n       = changes.end() - largest;
      return n > 1 && *largest > 0 ? std::pow(changes.back() / *largest, 1. / (n - 1)) : 1.;
    }
  } // namespace



  // The changes decrease with the square root of the length of the load steps at least, and a
  // smaller observed ratio than that of order one may be chance.
  void
  PathErrors::set(const unsigned int parts, const std::vector<Values> &histories)
  {
    constexpr double                       least = 0.5, most = 0.85;
    const std::vector<std::vector<Change>> before = std::move(changes);
    const Values                          &coarse = histories.front();
    first_parts                                   = parts;
    has_rate                                      = has_rate || histories.size() > 2;
    changes.assign(coarse.size(), {});
    for (unsigned int step = 0; step < coarse.size(); ++step)
      for (unsigned int i = 0; i < coarse[step].size(); ++i)
        {
          // Without any change, as where nothing slips, the ratio does not matter.
          Change one{{}, most, std::abs(coarse[step][i])};
          for (unsigned int k = 1; k < histories.size(); ++k)
            one.by_doubling.push_back(std::abs(histories[k][step][i] - histories[k - 1][step][i]));
          if (one.by_doubling.size() > 1)
            one.ratio = std::clamp(mean_ratio(one.by_doubling), least, most);
          else if (step < before.size() && i < before[step].size())
            one.ratio = before[step][i].ratio;
          changes[step].push_back(one);
        }
  }



  // The sum of the changes with all further doublings, those that were not tried as a geometric
  // series: the last history is not taken for the limit.
  std::vector<double>
  PathErrors::errors(const unsigned int load_step, const unsigned int parts) const
  {
    constexpr double    safety   = 1.3;
    const int           doubling = std::lround(std::log2(double(parts) / first_parts));
    std::vector<double> result;
    for (const Change &one : changes[load_step])
      {
        const int n = one.by_doubling.size();
        // No history with more parts: nothing tells the error, which may be all of the value.
        if (n == 0)
          {
            result.push_back(one.size);
            continue;
          }
        // Beyond the last history: its change times the sum of ratio + ratio^2 + ... A single
        // change may be small by chance.
        const double last =
          std::max(one.by_doubling.back(), n > 1 ? one.ratio * one.by_doubling[n - 2] : 0.);
        double rest = last * one.ratio / (1 - one.ratio);
        for (int k = n - 1; k >= std::max(doubling, 0); --k)
          rest += one.by_doubling[k];
        for (int k = n; k < doubling; ++k)
          rest *= one.ratio;
        result.push_back(safety * rest);
      }
    return result;
  }
} // namespace Signorini
