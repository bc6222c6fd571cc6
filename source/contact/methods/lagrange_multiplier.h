// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/contact/methods/method.h>

namespace Signorini
{
  /// Lagrange multiplier method (doc/theory, 2.5): the contact pressure is an unknown in a space of
  /// functions on the slave, one a node; the gap weighted with them vanishes where it acts. The
  /// active set follows from p - c g > 0; c only steers the iteration, not the result.
  class LagrangeMultiplier : public ContactMethod
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
      return complementarity_factor * scale.stiffness;
    }

  private:
    double complementarity_factor = 1;
  };
} // namespace Signorini
