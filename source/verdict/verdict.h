// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include <iosfwd>
#include <string>
#include <vector>

namespace Signorini
{
  /// From good to bad.
  enum class Outcome
  {
    passed,
    warned, ///< the answer may be off: what, where, how much, and what to do about it
    failed  ///< it is none
  };

  /// What one question about a solution gave.
  struct CheckResult
  {
    std::string check; ///< "strain"
    std::string where; ///< "pair fit", "body ring"; may be empty
    double      value = 0, limit = 0;
    Outcome     outcome = Outcome::passed;
    std::string message = {}, advice = {}; ///< of those that did not pass

    /// Which load step counts.
    enum class Aggregation
    {
      worst, ///< the one with the worst outcome, of those the one with the largest value
      last,
      best
    } aggregation = Aggregation::worst;
  };

  /// What could make an answer wrong and cannot be seen in its residual, asked after each load
  /// step.
  class Verdict
  {
  public:
    /// @param time of the load step
    void
    add(const std::vector<CheckResult> &of_step, double time);

    Outcome
    outcome() const;

    /// {"outcome": "warned", "checks": [{"check", "where", "value", "limit", "outcome", "time",
    /// "message", "advice"}]}, in the order in which they were asked; the last two are empty if
    /// passed.
    nlohmann::ordered_json
    json() const;

    /// What json() told.
    static Verdict
    from(const nlohmann::ordered_json &json);

    /// How many passed, and what did not: three lines each.
    void
    print(std::ostream &out) const;

    /// "strain of ring: ..." of all that has that outcome.
    std::string
    summary(Outcome outcome) const;

  private:
    struct Entry
    {
      CheckResult check_result;
      double      time;
    };

    std::vector<Entry> entries;
  };
} // namespace Signorini
