// SPDX-License-Identifier: Apache-2.0
#include "verdict/verdict.h"

#include <algorithm>
#include <iomanip>
#include <limits>
#include <ostream>

namespace Signorini
{
  namespace
  {
    /// @return the name of an outcome in results.json.
    const char *
    name(const Outcome outcome)
    {
      return outcome == Outcome::passed ? "passed" :
             outcome == Outcome::warned ? "warned" :
                                          "failed";
    }

    /// @return whether a check result is worse than another one.
    bool
    is_worse(const CheckResult &a, const CheckResult &b)
    {
      return a.outcome != b.outcome ? a.outcome > b.outcome : a.value > b.value;
    }

    /// @return whether the result of a later load step replaces that of an earlier one.
    bool
    replaces(const CheckResult &now, const CheckResult &before)
    {
      // For `best` an earlier result is replaced if it was worse, so that one good load step
      // suffices.
      switch (now.aggregation)
        {
          case CheckResult::Aggregation::last:
            return true;
          case CheckResult::Aggregation::best:
            return is_worse(before, now);
          default:
            return is_worse(now, before);
        }
    }

    /// @return name and place of a check.
    std::string
    title(const CheckResult &check_result)
    {
      return check_result.check + (check_result.where.empty() ? "" : ", ") + check_result.where;
    }
  } // namespace



  // Each check of each place has one entry, of the load step that its aggregation selects.
  void
  Verdict::add(const std::vector<CheckResult> &of_step, const double time)
  {
    for (const CheckResult &now : of_step)
      {
        // Name and place identify a check.
        const auto same = std::find_if(entries.begin(), entries.end(), [&](const Entry &entry) {
          return entry.check_result.check == now.check && entry.check_result.where == now.where;
        });
        if (same == entries.end())
          entries.push_back({now, time});
        else if (replaces(now, same->check_result))
          *same = {now, time};
      }
  }



  // The outcome is that of the worst check.
  Outcome
  Verdict::outcome() const
  {
    Outcome worst = Outcome::passed;
    for (const Entry &entry : entries)
      worst = std::max(worst, entry.check_result.outcome);
    return worst;
  }



  // Messages and advice are written only for checks that have not passed.
  nlohmann::ordered_json
  Verdict::json() const
  {
    nlohmann::ordered_json checks = nlohmann::ordered_json::array();
    for (const auto &[check_result, time] : entries)
      {
        // Texts are composed by the checks whatever their outcome, and are wrong if nothing is.
        const bool passed = check_result.outcome == Outcome::passed;
        checks.push_back({{"check", check_result.check},
                          {"where", check_result.where},
                          {"value", check_result.value},
                          {"limit", check_result.limit},
                          {"outcome", name(check_result.outcome)},
                          {"time", time},
                          {"message", passed ? "" : check_result.message},
                          {"advice", passed ? "" : check_result.advice}});
      }
    return {{"outcome", name(outcome())}, {"checks", checks}};
  }



  Verdict
  Verdict::from(const nlohmann::ordered_json &json)
  {
    // JSON has no NaN: it is written as null.
    const auto number = [](const nlohmann::ordered_json &value) {
      return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
    };
    Verdict result;
    for (const auto &check : json.at("checks"))
      {
        CheckResult check_result{check.at("check"),
                                 check.at("where"),
                                 number(check.at("value")),
                                 number(check.at("limit"))};
        check_result.message = check.at("message");
        check_result.advice  = check.at("advice");
        // The name is compared with those of all outcomes; the aggregation is not stored, because
        // later load steps bring their own.
        for (const Outcome outcome : {Outcome::passed, Outcome::warned, Outcome::failed})
          if (check.at("outcome") == name(outcome))
            check_result.outcome = outcome;
        result.entries.push_back({check_result, check.at("time")});
      }
    return result;
  }



  // Only checks that have not passed are printed, with their value, limit, and load step.
  void
  Verdict::print(std::ostream &out) const
  {
    if (entries.empty())
      return;
    const auto n_passed = std::count_if(entries.begin(), entries.end(), [](const Entry &entry) {
      return entry.check_result.outcome == Outcome::passed;
    });
    out << "\n  Verdict: " << n_passed << " of " << entries.size() << " checks passed\n";
    for (const auto &[check_result, time] : entries)
      if (check_result.outcome != Outcome::passed)
        // Numbers with three digits are enough to compare a value with its limit.
        out << "    " << (check_result.outcome == Outcome::warned ? "WARNED  " : "FAILED  ")
            << title(check_result) << ": " << std::defaultfloat << std::setprecision(3)
            << check_result.value << ", limit " << check_result.limit << ", t = " << time
            << "\n      " << check_result.message << "\n      " << check_result.advice << "\n";
  }



  std::string
  Verdict::summary(const Outcome outcome) const
  {
    std::string text;
    for (const auto &[check_result, time] : entries)
      if (check_result.outcome == outcome)
        text += (text.empty() ? "" : "; ") + title(check_result) + ": " + check_result.message +
                "; " + check_result.advice;
    return text;
  }
} // namespace Signorini
