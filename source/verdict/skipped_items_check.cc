// SPDX-License-Identifier: Apache-2.0
#include "scene/skipped_items.h"
#include "verdict/checks.h"

namespace Signorini
{
  // One check lists all omissions that may influence the solution.
  template <int dim>
  std::vector<CheckResult>
  check_skipped_items(const Scene<dim> &scene, const bool acts)
  {
    CheckResult check_result;
    check_result.check       = "not imported";
    check_result.aggregation = CheckResult::Aggregation::best; // a history may begin with nothing
    std::string acting;
    // Features that the program does not model, such as friction, are left out here: see
    // SkippedItem::acts().
    for (const SkippedItem &one : skipped_in(scene.skipped_items))
      if (one.acts())
        {
          ++check_result.value;
          acting += (acting.empty() ? "" : "; ") + one.kind + ": " + one.what;
        }
    if (check_result.value == 0)
      return {};
    check_result.outcome = acts ? Outcome::warned : Outcome::failed;
    check_result.message =
      (acts ? "the imported model lacks " :
              "no force acts and nothing moves in the imported model, which lacks ") +
      acting;
    check_result.advice =
      "define it in the scene as a support, load, obstacle or contact pair, and remove it "
      "from Not imported";
    return {check_result};
  }



  template std::vector<CheckResult>
  check_skipped_items(const Scene<2> &, bool);
  template std::vector<CheckResult>
  check_skipped_items(const Scene<3> &, bool);
} // namespace Signorini
