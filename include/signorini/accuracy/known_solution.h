// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/parameters/expression.h>

#include <string>

namespace Signorini
{
  class Section;

  /// What is known of the solution, as formulas of the coordinates and the time.
  template <int dim>
  struct KnownSolution
  {
    VectorExpression<dim> displacement;      ///< empty: not known
    Formula               pressure;          ///< empty: not known
    Formula               volumetric_stress; ///< of mixed bodies; empty: not known

    void
    declare(Section &section);
  };
} // namespace Signorini
