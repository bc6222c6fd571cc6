// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/contact/methods/method.h>

namespace Signorini
{
  /// Direct constraint elimination (doc/theory, 2.6): slave nodes that touch lie on the master
  /// surface, u^S . n = u^M . n - g_0, whatever the nodes of the master: node-to-node where meshes
  /// match, node-to-surface elsewhere. The linear solver eliminates these constraints, so that what
  /// it iterates on is symmetric and positive definite; the forces that they transmit follow from
  /// equilibrium and are returned as pressures by the areas of the nodes. Exact on matching meshes;
  /// elsewhere as any collocation it fails the patch test (by some percent).
  class DirectElimination : public ContactMethod
  {
  public:
    void
    declare(Section &section) override;

    Sampling
    sampling() const override
    {
      return Sampling::nodes;
    }

    PressureShift
    pressure_shift() const override
    {
      return PressureShift::multiplier;
    }

    bool
    has_multipliers() const override
    {
      return true;
    }

    double
    penalty(const PenaltyScale &scale) const override
    {
      return scale.stiffness;
    }

    Rule
    usual_integration() const override
    {
      return Rule::nodes;
    }

    void
    check(const Integration &integration, unsigned int degree) const override;
  };
} // namespace Signorini
