// SPDX-License-Identifier: Apache-2.0
#include "contact/methods/perturbed_lagrangian.h"

#include <signorini/parameters/section.h>

namespace Signorini
{
  void
  PerturbedLagrangian::declare(Section &section)
  {
    penalty_factor.declare(
      section,
      "penalty parameter (contact stiffness) in units of E/h; the penetration is p h / (Factor E)");
    section.rename_key("Form", "System");
    section.rename_choice("System", "block", "saddle point");
    section.add_choice("System",
                       form,
                       {{"saddle point", Form::block}, {"condensed", Form::condensed}},
                       "saddle point: the pressure is an unknown; condensed: it is eliminated");
  }
} // namespace Signorini
