// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace Signorini
{
  class Section;

  /// The treatment of rigid-body modes that neither supports nor contact constrain and no force
  /// excites.
  enum class UnconstrainedModeTreatment
  {
    /// An error.
    refuse,
    /// Stabilisation by forces that are small and reported.
    hold
  };

  /// The settings of Newton's method, section Newton of a scene.
  struct NewtonSettings
  {
    /// Maximal number of steps of one solution.
    unsigned int maximum_steps = 40;
    /// Tolerance of the residual, relative to the acting forces.
    double tolerance = 1e-10;
    /// Tolerance of the residual after a geometry update (doc/theory, (5.3)).
    double of_geometry = 1e-8;
    /// Reduction of residuals by linear solves while the active set changes (forcing term).
    double reduction = 1e-2;
    /// Stabilisation of unconstrained modes in units of E times the size of the body.
    double                     stabilisation      = 0.25;
    UnconstrainedModeTreatment undetermined_modes = UnconstrainedModeTreatment::refuse;

    /// Advice about unconstrained modes, for messages.
    static std::string
    stabilisation_advice();

    /// Declare the keys.
    void
    declare(Section &section);
  };
} // namespace Signorini
