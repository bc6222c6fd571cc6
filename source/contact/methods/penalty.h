// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/methods/penalty_factor.h"

namespace Signorini
{
  /// Penalty method (doc/theory, 2.2): p = max(0, -eps g). Bodies penetrate by p/eps.
  class Penalty : public ContactMethod
  {
  public:
    /// Which gap is penalised.
    enum class Weighting
    {
      mortar,   ///< that weighted at the slave nodes
      pointwise ///< that at each quadrature point
    };

    void
    declare(Section &section) override;

    Sampling
    sampling() const override
    {
      return weighting == Weighting::mortar ? Sampling::nodes : Sampling::quadrature_points;
    }

    PressureShift
    pressure_shift() const override
    {
      return PressureShift::none;
    }

    bool
    has_multipliers() const override
    {
      return false;
    }

    /// eps = Factor E/h (L/h)^Growth, with the size L of the scene; or Stiffness.
    double
    penalty(const PenaltyScale &scale) const override;

    /// Segments, if the displacement can follow: by few points of faces that do not match,
    /// pressures swing more than by many, the more so beside hanging nodes.
    Rule
    usual_integration() const override
    {
      return weighting == Weighting::mortar || is_low_penalty() ? Rule::segments : Rule::quadrature;
    }

    void
    check(const Integration &integration, unsigned int degree) const override;


  private:
    /// Soft enough for more points of a face than it has nodes.
    bool
    is_low_penalty() const
    {
      constexpr double largest = 10; // peaks of 3 % seen with it in Hertz contact, 8 % with 30
      return !penalty_factor.is_absolute() && penalty_factor.factor <= largest;
    }

    PenaltyFactor penalty_factor;
    double        growth    = 0;
    Weighting     weighting = Weighting::mortar;
  };
} // namespace Signorini
