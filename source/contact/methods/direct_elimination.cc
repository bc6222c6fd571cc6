// SPDX-License-Identifier: Apache-2.0
#include "contact/methods/direct_elimination.h"

#include <signorini/parameters/section.h>

namespace Signorini
{
  void
  DirectElimination::declare(Section & /*section*/)
  {}



  void
  DirectElimination::check(const Integration &integration, const unsigned int /*degree*/) const
  {
    if (integration.rule != Rule::nodes)
      throw SceneError(
        "Contact method/Integration = " + word_of(Integration::rules(), integration.rule) +
        " cannot be combined with Method = direct elimination, which is a node-to-surface method; "
        "set Integration = nodes, or Method = Lagrange multiplier");
  }
} // namespace Signorini
