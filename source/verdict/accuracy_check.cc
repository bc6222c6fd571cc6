#include <signorini/verdict/checks.h>

#include <cmath>

namespace Signorini
{
  std::vector<Finding>
  check_targets(const Goals &goals, const ErrorControl &control, const std::string &why)
  {
    std::vector<Finding> findings;
    for (unsigned int i = 0; i < goals.quantities.size(); ++i)
      {
        const ValueWithBar now = control.quantities()[i].last_with_bar();
        Finding            finding;
        finding.check   = "error bar";
        finding.where   = goals.quantities[i];
        finding.value   = now.value != 0 ? now.bar / std::abs(now.value) : now.bar;
        finding.limit   = goals.targets[i];
        finding.outcome = finding.value <= finding.limit ? Outcome::passed : Outcome::warned;
        finding.what    = "the bar is larger than the Target error: " + why;
        finding.cure    = "take the value with its bar, or give it more time, memory and cells";
        findings.push_back(finding);
      }
    return findings;
  }
} // namespace Signorini
