// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include <iosfwd>
#include <string>
#include <vector>

namespace Signorini
{
  /// The outcome of a check, in the order of severity.
  enum class Outcome
  {
    passed,
    /// The result may be wrong to some extent; the message says where, how much, and what can be
    /// done.
    warned,
    /// The result is invalid.
    failed
  };

  /// The result of one check of a solution.
  struct CheckResult
  {
    /// Name of the check, such as "displacement gradient".
    std::string check;
    /// What it refers to, such as "pair fit" or "body ring"; may be empty.
    std::string where;
    double      value = 0, limit = 0;
    Outcome     outcome = Outcome::passed;
    /// What is wrong, and what can be done about it, if the check has not passed.
    std::string message = {}, advice = {};

    /// Which load step is reported.
    enum class Aggregation
    {
      /// The one with the worst outcome, of those the one with the largest value.
      worst,
      last,
      best
    } aggregation = Aggregation::worst;
  };

  /// Collects the results of checks, after each load step, of what could make a solution wrong
  /// without being visible in its residual.
  class Verdict
  {
  public:
    /// Add the checks of a load step.
    /// @param of_step their results
    /// @param time of the load step
    void
    add(const std::vector<CheckResult> &of_step, double time);

    /// @return the worst outcome of all checks.
    Outcome
    outcome() const;

    /// @return {"outcome": "warned", "checks": [{"check", "where", "value", "limit", "outcome",
    /// "time", "message", "advice"}]}, in the order of the checks; message and advice are empty if
    /// a check has passed.
    nlohmann::ordered_json
    json() const;

    /// @return the verdict that json() has written.
    /// @param json its result
    static Verdict
    from(const nlohmann::ordered_json &json);

    /// Print how many checks have passed, and three lines for each of the others.
    /// @param out the stream
    void
    print(std::ostream &out) const;

    /// @return the messages of all checks with an outcome, such as "strain of ring: ...".
    /// @param outcome of the checks
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
