// SPDX-License-Identifier: Apache-2.0
#include "accuracy/path_errors.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace Signorini;

namespace
{
  /// Histories of one load step and one quantity with the limit 1 and an error of a given order.
  PathErrors
  of_order(const double order)
  {
    PathErrors                      result;
    std::vector<PathErrors::Values> histories;
    for (const double parts : {1., 2., 4.})
      histories.push_back({{1 - 0.3 * std::pow(parts, -order)}});
    result.set(1, histories);
    return result;
  }
} // namespace

TEST_CASE("errors of the path contain what is left, whatever their order is")
{
  for (const double order : {0.3, 0.5, 1., 2.})
    for (const unsigned int parts : {1, 2, 4, 8, 16})
      {
        CAPTURE(order);
        CAPTURE(parts);
        const double error = 0.3 * std::pow(parts, -order),
                     bound = of_order(order).errors(0, parts)[0];
        CHECK(bound >= error);
        // Orders above one are not relied on.
        CHECK(bound <=
              1.5 * error * std::pow(parts, std::max(0., order - 1)) * (order > 1 ? 2 : 1));
      }
}

TEST_CASE("two histories use the rate of three, and one has no bound below its value")
{
  PathErrors path = of_order(0.5);
  path.set(2, {{{1 - 0.3 * std::pow(2, -0.5)}}, {{1 - 0.3 * std::pow(4, -0.5)}}});
  CHECK(path.errors(0, 4)[0] == doctest::Approx(1.3 * 0.15));
  CHECK(path.errors(0, 16)[0] == doctest::Approx(1.3 * 0.075));
  path.set(2, {{{-3.}}});
  CHECK(path.errors(0, 2)[0] == 3);
}
