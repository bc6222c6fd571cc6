// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/laws/contact_law.h"
#include <signorini/contact/methods/method.h>

namespace Signorini
{
  /// Frictionless contact, one law for all methods (doc/theory, 2.1; pressure positive in
  /// compression, gap positive when open):
  ///
  ///   p = max(0, p^ - eps g),
  ///
  /// where the active set is where the maximum is positive. At points of bilateral pairs p = p^ -
  /// eps g, and they are always active. If the pressure is an independent unknown, the equation on
  /// active points is g + c p = 0, with the compliance c = 0, or c = 1/eps if p^ = 0 (perturbed
  /// Lagrangian). The overclosure d(p) of a compliant interface is added to the gap in these
  /// equations, so that p = (max(0, p^ - eps (g + d(0)))) with the resolvent of
  /// ContactCompliance::pressure().
  class NormalContact : public ContactLaw
  {
  public:
    /// Keeps a reference to the gap operator.
    NormalContact(const ContactMethod &method, const GapOperator &contact);

    /// A linear penalty law p = -factor E/h g on active points, whatever the method; for
    /// preconditioners and estimates.
    static NormalContact
    springs(const GapOperator &contact, double factor);

    bool
    has_multiplier() const override
    {
      return multiplier;
    }

    /// True if p^ is the pressure of the last solution.
    bool
    augments() const override
    {
      return pressure_shift == PressureShift::last_pressure;
    }

    void
    augment(const PointVectors &traction) override
    {
      last = traction[0];
    }

    /// The factor applies to the penalty of all points. Laws with multipliers and Nitsche's method
    /// do not use it: their minimal_penalty_scale() is 1.
    bool
    scale_penalty(const double factor) override
    {
      const bool changes = factor != penalty_scale;
      penalty_scale      = factor;
      return changes;
    }

    bool
    has_constant_derivatives() const override
    {
      return !contact.coefficients.has_nonlinear_compliance;
    }

    bool
    has_scaled_penalty() const override
    {
      return penalty_scale < 1;
    }

    double
    minimal_penalty_scale() const override;

    using ContactLaw::status;
    using ContactLaw::trial;

    /// p^ - eps g, the pressure without the bound of the law; positive values of compliant
    /// interfaces are pressures already.
    LawVector
    trial(Index point, const LawInput &in) const override;

    ContactStatus
    status(Index point, const LawVector &trial) const override;

    LawResponse
    response(Index point, const LawInput &in, ContactStatus status) const override;

    /// p - c (g + p/eps) with c at most E/h, whose sign at a solution is that of p^ - eps g for any
    /// c. With a stiff penalty, gaps that were interpolated from an earlier mesh are dominated by
    /// interpolation errors and would not show the active set.
    PointVectors
    trial_from_traction(const LawInputs &in) const override;

    /// E/h; or eps if the law augments, since then the residual times eps is the change by the next
    /// augmentation.
    double
    residual_stiffness(const Index point) const override
    {
      return augments() ? epsilon(point) : ContactLaw::residual_stiffness(point);
    }

    /// The penalty parameter at a point [force/length^3].
    double
    epsilon(const Index point) const
    {
      return spring < 0 ? penalty_scale * contact.coefficients.epsilon(point) :
                          spring * contact.coefficients.stiffness(point);
    }

    /// The trial pressure of an interface, and its derivative by p^ - eps g.
    /// @param point the point @param rigid p^ - eps g, that of a rigid interface
    /// @param epsilon the penalty parameter in it
    ContactCompliance::Value
    trial_pressure(Index point, double rigid, double epsilon) const;

  private:
    NormalContact(const GapOperator &contact,
                  PressureShift      pressure_shift,
                  bool               multiplier,
                  double             spring);

    PressureShift pressure_shift;
    bool          multiplier;
    /// Factor of E/h of springs(); negative: epsilon of the method.
    double spring;
    double penalty_scale = 1;
    /// The pressure of the last solution, p^ of Uzawa's method.
    LA::Vector last;
  };
} // namespace Signorini
