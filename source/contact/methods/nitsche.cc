// SPDX-License-Identifier: Apache-2.0
#include "contact/methods/nitsche.h"

#include <signorini/parameters/section.h>

#include <sstream>

namespace Signorini
{
  void
  Nitsche::declare(Section &section)
  {
    section.add_choice("Theta",
                       weight_of_stress,
                       {{"1", 1}, {"0", 0}, {"-1", -1}},
                       "1: symmetric systems; 0: fewest terms; -1: stable for any Factor");
    section.add(
      "Factor",
      safety_factor,
      "stabilisation parameter, in units of the smallest stable one, which follows from an "
      "eigenvalue problem on each face",
      positive);
    section.add("Unbiased",
                two_sided,
                "unbiased (two-pass) formulation: both surfaces are integrated with weight 1/2");
  }



  void
  Nitsche::check(const Integration &integration, const unsigned int /*degree*/) const
  {
    if (integration.rule == Rule::nodes)
      throw SceneError(
        "Contact method/Integration = nodes cannot be combined with Method = Nitsche, whose "
        "stabilisation bounds the mean stress of faces, not nodal stresses; set Integration = "
        "quadrature");
    // Stability: the quadratic form of the linearisation is bounded from below by (1 - (1 +
    // theta)^2/(4 Factor)) K (doc/theory, (2.18)).
    const double smallest = (1 + theta()) * (1 + theta()) / 4;
    if (safety_factor > smallest || theta() == -1)
      return;
    std::ostringstream text;
    text << "Contact method/Nitsche/Factor = " << safety_factor
         << " with Theta = " << weight_of_stress << " is not stable; set one above " << smallest
         << " (2 is usual), or Theta = -1";
    throw SceneError(text.str());
  }
} // namespace Signorini
