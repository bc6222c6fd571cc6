#include "verdict/verdict.h"

#include <algorithm>
#include <iomanip>
#include <limits>
#include <ostream>

namespace Signorini
{
  namespace
  {
    const char *
    name(const Outcome outcome)
    {
      return outcome == Outcome::passed ? "passed" :
             outcome == Outcome::warned ? "warned" :
                                          "failed";
    }

    bool
    is_worse(const Finding &a, const Finding &b)
    {
      return a.outcome != b.outcome ? a.outcome > b.outcome : a.value > b.value;
    }

    bool
    replaces(const Finding &now, const Finding &before)
    {
      switch (now.over)
        {
          case Finding::Over::last:
            return true;
          case Finding::Over::best:
            return is_worse(before, now);
          default:
            return is_worse(now, before);
        }
    }

    std::string
    title(const Finding &finding)
    {
      return finding.check + (finding.where.empty() ? "" : ", ") + finding.where;
    }
  } // namespace



  void
  Verdict::add(const std::vector<Finding> &of_step, const double time)
  {
    for (const Finding &now : of_step)
      {
        const auto same = std::find_if(entries.begin(), entries.end(), [&](const Entry &entry) {
          return entry.finding.check == now.check && entry.finding.where == now.where;
        });
        if (same == entries.end())
          entries.push_back({now, time});
        else if (replaces(now, same->finding))
          *same = {now, time};
      }
  }



  Outcome
  Verdict::outcome() const
  {
    Outcome worst = Outcome::passed;
    for (const Entry &entry : entries)
      worst = std::max(worst, entry.finding.outcome);
    return worst;
  }



  nlohmann::ordered_json
  Verdict::json() const
  {
    nlohmann::ordered_json checks = nlohmann::ordered_json::array();
    for (const auto &[finding, time] : entries)
      {
        const bool passed = finding.outcome == Outcome::passed;
        checks.push_back({{"check", finding.check},
                          {"where", finding.where},
                          {"value", finding.value},
                          {"limit", finding.limit},
                          {"outcome", name(finding.outcome)},
                          {"time", time},
                          {"message", passed ? "" : finding.what},
                          {"advice", passed ? "" : finding.cure}});
      }
    return {{"outcome", name(outcome())}, {"checks", checks}};
  }



  Verdict
  Verdict::from(const nlohmann::ordered_json &json)
  {
    // JSON has no word for what is not a number.
    const auto number = [](const nlohmann::ordered_json &value) {
      return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
    };
    Verdict result;
    for (const auto &check : json.at("checks"))
      {
        Finding finding{check.at("check"),
                        check.at("where"),
                        number(check.at("value")),
                        number(check.at("limit"))};
        finding.what = check.at("message");
        finding.cure = check.at("advice");
        for (const Outcome outcome : {Outcome::passed, Outcome::warned, Outcome::failed})
          if (check.at("outcome") == name(outcome))
            finding.outcome = outcome;
        result.entries.push_back({finding, check.at("time")});
      }
    return result;
  }



  void
  Verdict::print(std::ostream &out) const
  {
    if (entries.empty())
      return;
    const auto n_passed = std::count_if(entries.begin(), entries.end(), [](const Entry &entry) {
      return entry.finding.outcome == Outcome::passed;
    });
    out << "\n  Verdict: " << n_passed << " of " << entries.size() << " checks passed\n";
    for (const auto &[finding, time] : entries)
      if (finding.outcome != Outcome::passed)
        out << "    " << (finding.outcome == Outcome::warned ? "WARNED  " : "FAILED  ")
            << title(finding) << ": " << std::defaultfloat << std::setprecision(3) << finding.value
            << ", limit " << finding.limit << ", t = " << time << "\n      " << finding.what
            << "\n      " << finding.cure << "\n";
  }



  std::string
  Verdict::summary(const Outcome outcome) const
  {
    std::string text;
    for (const auto &[finding, time] : entries)
      if (finding.outcome == outcome)
        text +=
          (text.empty() ? "" : "; ") + title(finding) + ": " + finding.what + "; " + finding.cure;
    return text;
  }
} // namespace Signorini
