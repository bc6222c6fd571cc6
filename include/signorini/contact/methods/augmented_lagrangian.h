#pragma once

#include <signorini/contact/method.h>

namespace Signorini
{
  /// Augmented Lagrangian method (Uzawa), thesis 3.2: a sequence of penalty solutions
  /// p = max(0, p^ - eps g), each of which starts from the pressure p^ of the one before, until the
  /// gap weighted at the slave nodes is closed. The result is that of the Lagrange multiplier
  /// method, from systems without multipliers. The gap falls by about 1/(1 + Factor) each time.
  class AugmentedLagrangian : public ContactMethod
  {
  public:
    void
    declare(Section &section) override;

    Sampling
    sampling() const override
    {
      return Sampling::nodes;
    }

    bool
    has_multipliers() const override
    {
      return false;
    }

    double
    factor() const override
    {
      return penalty_factor;
    }

    bool
    augments() const override
    {
      return true;
    }

  private:
    double penalty_factor = 1000;
  };
} // namespace Signorini
