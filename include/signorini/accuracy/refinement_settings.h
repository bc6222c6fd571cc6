// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace Signorini
{
  class Section;

  /// How meshes are refined.
  struct RefinementSettings
  {
    /// Which cells are refined.
    enum class Strategy
    {
      /// Cells where the error estimate is largest.
      estimator,
      /// All cells.
      global
    };

    /// Number of refinements.
    unsigned int cycles   = 0;
    Strategy     strategy = Strategy::estimator;
    /// Fraction of the cells that are refined.
    double refine_fraction = 0.15;
    /// Fraction of the cells that are coarsened.
    double coarsen_fraction = 0.03;
    /// No refinement beyond this number of cells.
    unsigned int maximum_cells = 10000000;
    /// Relative tolerance of Newton's method on all meshes but the last.
    double tolerance = 1e-4;

    /// Declare the keys and read their values.
    /// @param section `Accuracy`
    void
    declare(Section &section);
  };
} // namespace Signorini
