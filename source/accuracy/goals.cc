// SPDX-License-Identifier: Apache-2.0
#include <signorini/accuracy/goals.h>
#include <signorini/base/text.h>
#include <signorini/parameters/section.h>

namespace Signorini
{
  void
  Goals::declare(Section &section)
  {
    // Beyond, sums of pressures are rounding.
    constexpr double least = 1e-8;
    section.add(
      "Quantity",
      quantities,
      "quantities of interest, for which error bounds are estimated: 'force of PAIR', "
      "'reaction y of SUPPORT', 'largest pressure of PAIR'; several are separated by commas");
    section.add("Target error",
                targets,
                "relative error bound, one for each Quantity or one for all: the mesh is refined "
                "until all error bounds are smaller; empty: none");
    section.add_choice(
      "Load steps",
      steps,
      {{"all", JudgedSteps::all}, {"last", JudgedSteps::last}},
      "load steps that have error bounds, and must satisfy the Target error; all: the mesh is refined "
      "for each of them if needed; last: the mesh is refined for the last one, and the others use "
      "that mesh and have no error bounds");
    section.add(
      "Time limit",
      time_limit,
      "no refinement that would end later; 0: none [minutes of wall time since the program was started]",
      non_negative);
    if (!section.reading())
      return;
    for (const double target : targets)
      if (!(target >= least))
        section.fail("Target error",
                     "is below " + short_text(least) +
                       ": forces and pressures are at the level of round-off there, and errors "
                       "cannot be estimated; set a larger one");
    if (has_targets() && quantities.empty())
      section.fail(
        "Target error",
        "requires Accuracy/Quantity; set it to the quantity that is to be this accurate");
    if (targets.size() == 1)
      targets.resize(quantities.size(), targets[0]);
    if (has_targets() && targets.size() != quantities.size())
      section.fail("Target error",
                   "has " + std::to_string(targets.size()) + " numbers, but Quantity has " +
                     std::to_string(quantities.size()) +
                     " entries; set one target for each quantity, or one for all");
  }
} // namespace Signorini
