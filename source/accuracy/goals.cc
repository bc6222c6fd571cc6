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
    section.add("Quantity",
                quantities,
                "what is wanted, with an error bar: names as 'force of PAIR', 'reaction y of "
                "SUPPORT', 'largest pressure of PAIR'; several are separated by commas");
    section.add("Target error",
                targets,
                "relative, one a quantity or one for all: the mesh is refined until the error bars "
                "are smaller; empty: none");
    section.add_choice(
      "Load steps",
      steps,
      {{"all", JudgedSteps::all}, {"last", JudgedSteps::last}},
      "which of them meet the Target error, each on a mesh that is refined for it and serves from there on; last: those "
      "before it have the mesh that its results need, and no bars");
    section.add("Time limit",
                time_limit,
                "no refinement that would last longer; 0: none [minutes of wall time since the "
                "program was started]",
                non_negative);
    if (!section.reading())
      return;
    for (const double target : targets)
      if (!(target >= least))
        section.fail("Target error",
                     "below " + short_text(least) +
                       ", where forces and pressures are rounding, no error can be told");
    if (has_targets() && quantities.empty())
      section.fail("Target error", "needs a Quantity: of what?");
    if (targets.size() == 1)
      targets.resize(quantities.size(), targets[0]);
    if (has_targets() && targets.size() != quantities.size())
      section.fail("Target error",
                   "has " + std::to_string(targets.size()) + " numbers, but Quantity has " +
                     std::to_string(quantities.size()) +
                     " names; give one for each, or one for all");
  }
} // namespace Signorini
