#pragma once

#include <signorini/contact/method.h>

namespace Signorini
{
  /// Perturbed Lagrangian method, thesis 3.2: the pressure is an unknown as in the Lagrange
  /// multiplier method, but the contact is elastic: g + p/eps = 0 at the slave nodes where it acts.
  /// Eliminating the pressure yields the penalty method with mortar weighting, which has the same
  /// solution; here it stays, and the system is a saddle point that large factors do not hurt.
  class PerturbedLagrangian : public ContactMethod
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
      return true;
    }

    double
    factor() const override
    {
      return penalty_factor;
    }

    double
    compliance() const override
    {
      return 1 / penalty_factor;
    }

  private:
    double penalty_factor = 1000;
  };
} // namespace Signorini
