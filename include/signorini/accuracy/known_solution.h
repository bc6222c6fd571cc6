// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/parameters/expression.h>

#include <string>

namespace Signorini
{
  class Section;

  /// A known solution, or parts of it, as formulas of the coordinates and the time; empty formulas
  /// are unknown.
  template <int dim>
  struct KnownSolution
  {
    /// Displacement [length].
    VectorExpression<dim> displacement;
    /// Contact pressure [stress], positive in compression.
    Formula pressure;
    /// Volumetric stress [stress] of bodies in displacement-pressure form, positive in tension.
    Formula volumetric_stress;

    /// Declare the keys and read their values. Throws SceneError if a formula is not valid.
    /// @param section `Known solution`
    void
    declare(Section &section);
  };
} // namespace Signorini
