// SPDX-License-Identifier: Apache-2.0
#include "verdict/checks.h"

#include <doctest/doctest.h>

#include <sstream>

using namespace Signorini;

namespace
{
  CheckResult
  check_result(const std::string             &check,
               const double                   value,
               const Outcome                  outcome,
               const CheckResult::Aggregation aggregation = CheckResult::Aggregation::worst)
  {
    CheckResult result;
    result.check       = check;
    result.where       = "pair a";
    result.value       = value;
    result.limit       = 1;
    result.outcome     = outcome;
    result.message     = "what of " + check;
    result.advice      = "cure";
    result.aggregation = aggregation;
    return result;
  }
} // namespace



TEST_CASE("of several load steps the worst, the last or the best counts")
{
  constexpr auto passed = Outcome::passed, warned = Outcome::warned;
  Verdict        verdict;
  CHECK(verdict.outcome() == passed);
  const auto step = [&](const double time, const double value, const Outcome outcome) {
    verdict.add({check_result("worst", value, outcome),
                 check_result("last", value, outcome, CheckResult::Aggregation::last),
                 check_result("best", value, outcome, CheckResult::Aggregation::best)},
                time);
  };
  step(1, 0.5, passed);
  step(2, 3, warned);
  step(3, 2, warned);
  step(4, 0.7, passed);
  const auto checks = verdict.json()["checks"];
  REQUIRE(checks.size() == 3);
  CHECK(checks[0]["value"] == 3);
  CHECK(checks[0]["time"] == 2);
  CHECK(checks[0]["outcome"] == "warned");
  CHECK(checks[0]["message"] == "what of worst");
  CHECK(checks[1]["time"] == 4);
  CHECK(checks[1]["outcome"] == "passed");
  CHECK(checks[1]["message"] == "");
  CHECK(checks[2]["time"] == 1);
  CHECK(verdict.outcome() == warned);
  CHECK(verdict.json()["outcome"] == "warned");
  CHECK(verdict.summary(warned) == "worst, pair a: what of worst; cure");

  verdict.add({check_result("other", 2, Outcome::failed)}, 5);
  CHECK(verdict.outcome() == Outcome::failed);
  std::ostringstream table;
  verdict.print(table);
  CHECK(table.str().find("Verdict: 2 of 4 checks passed") != std::string::npos);
  CHECK(table.str().find(
          "FAILED  other, pair a: 2, limit 1, t = 5\n      what of other\n      cure\n") !=
        std::string::npos);
}



TEST_CASE("balances: passed, warned, failed")
{
  const auto outcomes = [](const double forces, const double moments) {
    const auto check_results =
      check_balance({{"largest_force", 2.},
                     {"bodies",
                      {{"good", {{"force_balance", 0.}, {"moment_balance", 0.}}},
                       {"bad", {{"force_balance", forces}, {"moment_balance", moments}}}}}},
                    4.,
                    1e-5);
    CHECK(check_results.at(0).where == "body bad");
    return std::pair(check_results.at(0).outcome, check_results.at(1).outcome);
  };
  CHECK(outcomes(1.9e-5, 1.9e-3) == std::pair(Outcome::passed, Outcome::passed));
  CHECK(outcomes(2.1e-5, 2.1e-3) == std::pair(Outcome::warned, Outcome::warned));
  CHECK(outcomes(0.21, 0.21) == std::pair(Outcome::failed, Outcome::failed));
}
