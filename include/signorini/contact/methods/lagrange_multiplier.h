#pragma once

#include <signorini/contact/method.h>

namespace Signorini
{
  /// Lagrange multiplier method, thesis (43)-(50): the contact pressure is an unknown in the trace
  /// space of the slave, the gap weighted with its shape functions vanishes where it acts. The
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

    bool
    has_multipliers() const override
    {
      return true;
    }

    double
    factor() const override
    {
      return complementarity_factor;
    }

  private:
    double complementarity_factor = 1;
  };
} // namespace Signorini
