// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace Signorini
{
  class Section;

  /// What is done about rigid-body modes that neither supports nor contact constrain and no force
  /// drives.
  enum class UnconstrainedModeTreatment
  {
    refuse,
    hold ///< by forces that are small and reported
  };

  struct NewtonSettings
  {
    unsigned int               maximum_steps      = 40;
    double                     tolerance          = 1e-10;
    double                     of_geometry        = 1e-8;
    double                     reduction          = 1e-2;
    double                     stabilisation      = 0.25;
    UnconstrainedModeTreatment undetermined_modes = UnconstrainedModeTreatment::refuse;

    /// Advice about unconstrained modes, for messages.
    static std::string
    stabilisation_advice();

    void
    declare(Section &section);
  };
} // namespace Signorini
