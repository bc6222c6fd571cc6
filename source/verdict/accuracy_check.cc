#include "verdict/checks.h"

#include <cmath>

namespace Signorini
{
  std::vector<Finding>
  check_targets(const Goals &goals, const ErrorControl &control, const std::string &why)
  {
    std::vector<Finding> findings;
    for (unsigned int i = 0; i < goals.quantities.size(); ++i)
      {
        const ValueWithBar now   = control.quantities()[i].last_with_bar();
        const double       scale = control.scale(i);
        Finding            finding;
        finding.check   = "error bound";
        finding.where   = goals.quantities[i];
        finding.value   = scale > 0 ? now.bar / scale : now.bar;
        finding.limit   = goals.targets[i];
        finding.outcome = finding.value <= finding.limit ? Outcome::passed : Outcome::warned;
        finding.what    = "the error bound is larger than the Target error: " + why;
        finding.cure =
          "use the value with its error bound, or allow more time, memory or cells (Accuracy/Time limit, Maximum cells)";
        findings.push_back(finding);
      }
    return findings;
  }



  std::vector<Finding>
  check_judged_steps(const unsigned int not_judged, const unsigned int all)
  {
    Finding finding;
    finding.check   = "load steps without error bounds";
    finding.value   = not_judged;
    finding.limit   = 0;
    finding.outcome = not_judged == 0 ? Outcome::passed : Outcome::warned;
    finding.what =
      std::to_string(not_judged) + " of " + std::to_string(all) +
      " load steps have no error bounds; they use the mesh of the last one, and their errors are unknown";
    finding.cure = "set Accuracy/Load steps = all";
    return {finding};
  }
} // namespace Signorini
