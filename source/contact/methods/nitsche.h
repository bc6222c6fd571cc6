// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/contact/methods/method.h>

namespace Signorini
{
  /// Nitsche's method (doc/theory, 2.7) in the form for contact of Chouly and Hild (SIAM J. Numer.
  /// Anal. 51 (2013) 1295-1307): p = max(0, s(u) - eps g) with the normal stress s of the bodies at
  /// the contact points, tested with v and theta s(v):
  ///
  ///   a(u, v) - theta int s(u) s(v)/eps dA + int p (-g'(v) + theta s(v)/eps) dA = f(v).
  ///
  /// Consistent: no penetration but that of the discretisation, and no multipliers. theta = 1: the
  /// system is symmetric; 0: the fewest terms; -1: stable for any eps. eps is a multiple of the
  /// bound of s(v)^2 by the energy of the cells behind the surfaces, so that no input is needed;
  /// see NormalStress::bound(). Unbiased: the surfaces are slaves of each other, with half the
  /// weight (Chouly, Mlika, Renard, Numer. Math. 139 (2018) 593-631).
  class Nitsche : public ContactMethod
  {
  public:
    void
    declare(Section &section) override;

    Sampling
    sampling() const override
    {
      return Sampling::quadrature_points;
    }

    PressureShift
    pressure_shift() const override
    {
      return PressureShift::normal_stress;
    }

    bool
    has_multipliers() const override
    {
      return false;
    }

    double
    penalty(const PenaltyScale &scale) const override
    {
      return safety_factor * scale.bound;
    }

    double
    theta() const override
    {
      return weight_of_stress;
    }

    bool
    unbiased() const override
    {
      return two_sided;
    }

    void
    check(const Integration &integration, unsigned int degree) const override;

  private:
    double safety_factor    = 2;
    int    weight_of_stress = 1; ///< theta
    bool   two_sided        = false;
  };
} // namespace Signorini
