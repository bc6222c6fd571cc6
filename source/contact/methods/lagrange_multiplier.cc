// SPDX-License-Identifier: Apache-2.0
#include "contact/methods/methods.h"
#include <signorini/contact/methods/method.h>
#include <signorini/parameters/section.h>

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



  void
  LagrangeMultiplier::declare(Section &section)
  {
    section.add(
      "Complementarity factor",
      complementarity_factor,
      "factor of the gap, in units of E/h, in the complementarity function p - c g of the active-set "
      "strategy; the result does not depend on it",
      positive);
  }



  std::shared_ptr<ContactMethod>
  make_lagrange_multiplier()
  {
    return std::make_shared<LagrangeMultiplier>();
  }
} // namespace Signorini
