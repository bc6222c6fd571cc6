// SPDX-License-Identifier: Apache-2.0
#include "verdict/checks.h"

#include <cmath>

namespace Signorini
{
  // Error bounds are relative to the scale of the quantity, as targets are.
  std::vector<CheckResult>
  check_targets(const Goals &goals, const ErrorControl &control, const std::string &why)
  {
    std::vector<CheckResult> check_results;
    for (unsigned int i = 0; i < goals.quantities.size(); ++i)
      {
        // The value of the last mesh for which an error was estimated. A quantity with the scale
        // zero has an absolute bound.
        const BoundedValue now   = control.quantities()[i].last_bounded();
        const double       scale = control.scale(i);
        CheckResult        check_result;
        check_result.check = "error bound";
        check_result.where = goals.quantities[i];
        check_result.value = scale > 0 ? now.error_bound / scale : now.error_bound;
        check_result.limit = goals.targets[i];
        check_result.outcome =
          check_result.value <= check_result.limit ? Outcome::passed : Outcome::warned;
        check_result.message = "the error bound is larger than the Target error: " + why;
        check_result.advice =
          "use the value with its error bound, or allow more time, memory or cells (Accuracy/Time limit, Maximum cells)";
        check_results.push_back(check_result);
      }
    return check_results;
  }



  // Load steps without an estimate have used the mesh that another one needed.
  std::vector<CheckResult>
  check_judged_steps(const unsigned int not_judged, const unsigned int all)
  {
    CheckResult check_result;
    check_result.check   = "load steps without error bounds";
    check_result.value   = not_judged;
    check_result.limit   = 0;
    check_result.outcome = not_judged == 0 ? Outcome::passed : Outcome::warned;
    check_result.message =
      std::to_string(not_judged) + " of " + std::to_string(all) +
      " load steps have no error bounds; they use the mesh of the last one, and their errors are unknown";
    check_result.advice = "set Accuracy/Load steps = all";
    return {check_result};
  }



  // Quantities with a limit need no line: there is one for each bar already.
  std::vector<CheckResult>
  check_limits(const Goals &goals, const ErrorControl &control)
  {
    std::vector<CheckResult> check_results;
    for (unsigned int i = 0; i < goals.quantities.size(); ++i)
      if (control.quantities()[i].last().is_singular)
        {
          CheckResult check_result;
          check_result.check   = "stress without limit";
          check_result.where   = goals.quantities[i];
          check_result.value   = 1;
          check_result.limit   = 0;
          check_result.outcome = Outcome::warned;
          check_result.message =
            "it is beside the end of a support that holds the body along its surface, or at a re-entrant corner, where the exact stress has no limit: the value depends on the mesh and has no error bound";
          check_result.advice =
            "use the stress at a point farther away (Output/Probes), or round the corner";
          check_results.push_back(check_result);
        }
    return check_results;
  }



  // The dual problem of a load step knows the errors of this step alone. What a former one has left
  // for good is seen only where the whole history was solved on several meshes, whose values
  // differ.
  std::vector<CheckResult>
  check_former_steps(const bool does_not)
  {
    CheckResult check_result;
    check_result.check   = "errors of former load steps";
    check_result.value   = does_not ? 1 : 0;
    check_result.limit   = 0;
    check_result.outcome = does_not ? Outcome::warned : Outcome::passed;
    check_result.message =
      "the state keeps what former load steps have left (a Lock time, ties that start later, or friction that changes in time), and a single mesh tells nothing of their errors: the error bounds are those of the last load step alone";
    check_result.advice =
      "set Accuracy/Target error or Refinement cycles: the history is then solved on several meshes, and what it changes is in the bounds";
    return {check_result};
  }
} // namespace Signorini
