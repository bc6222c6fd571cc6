// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace Signorini
{
  class Section;

  /// How meshes are refined for a quantity.
  struct RefinementSettings
  {
    /// Which cells are refined.
    enum class Strategy
    {
      estimator, ///< where the error estimate is largest
      global     ///< all
    };

    unsigned int cycles           = 0;
    Strategy     strategy         = Strategy::estimator;
    double       refine_fraction  = 0.15;
    double       coarsen_fraction = 0.03;
    unsigned int maximum_cells    = 10000000;
    double       tolerance        = 1e-4; ///< of Newton's method on all meshes but the last

    void
    declare(Section &section);
  };
} // namespace Signorini
