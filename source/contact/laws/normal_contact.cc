// SPDX-License-Identifier: Apache-2.0
#include "contact/laws/normal_contact.h"

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  NormalContact::NormalContact(const GapOperator  &contact,
                               const PressureShift pressure_shift,
                               const bool          multiplier,
                               const double        spring)
    : ContactLaw(contact)
    , pressure_shift(pressure_shift)
    , multiplier(multiplier && !contact.empty())
    , spring(spring)
    , last(contact.zero())
  {}



  NormalContact::NormalContact(const ContactMethod &method, const GapOperator &contact)
    : NormalContact(contact, method.pressure_shift(), method.has_multipliers(), -1)
  {}



  NormalContact
  NormalContact::springs(const GapOperator &contact, const double factor)
  {
    return {contact, PressureShift::none, false, factor};
  }



  // min over points of k/epsilon (doc/theory, 4.5); laws with multipliers and Nitsche's method have
  // no stiff penalty. Collective.
  double
  NormalContact::minimal_penalty_scale() const
  {
    if (contact.empty() || multiplier || pressure_shift == PressureShift::normal_stress)
      return 1;
    const LA::Vector &stiffness = contact.coefficients.stiffness,
                     &epsilon   = contact.coefficients.epsilon;
    double stiffest             = 1;
    for (const auto i : epsilon.locally_owned_elements())
      stiffest = std::max(stiffest, epsilon(i) / stiffness(i));
    return 1 / Utilities::MPI::max(stiffest, epsilon.get_mpi_communicator());
  }



  ContactCompliance::Value
  NormalContact::trial_pressure(const Index point, const double rigid, const double epsilon) const
  {
    const ContactCoefficients &of = contact.coefficients;
    return of.pressure(point, rigid - epsilon * of.overclosure(point, 0).value, epsilon);
  }



  // p^ - epsilon g of doc/theory, (2.1), with p^ of the method.
  LawVector
  NormalContact::trial(const Index point, const LawInput &in) const
  {
    const double predicted = pressure_shift == PressureShift::multiplier    ? in.traction[0] :
                             pressure_shift == PressureShift::normal_stress ? in.stress[0] :
                             pressure_shift == PressureShift::last_pressure ? last(point) :
                                                                              0.;
    LawVector    result;
    result[0] = trial_pressure(point, predicted - epsilon(point) * in.gap[0], epsilon(point)).value;
    return result;
  }



  // A point without area is open: it has no gap.
  ContactStatus
  NormalContact::status(const Index point, const LawVector &trial) const
  {
    const bool is_closed =
      (trial[0] > 0 || contact.coefficients.least_status(point) > 0) && contact.weight(point) > 0;
    return is_closed ? ContactStatus::slip : ContactStatus::open;
  }



  // The response (2.22).
  LawResponse
  NormalContact::response(const Index point, const LawInput &in, const ContactStatus status) const
  {
    LawResponse result;
    if (status == ContactStatus::open)
      return result;
    result.residual_by_gap[0][0] = 1;
    if (!multiplier)
      {
        result.traction = trial(point, in);
        const ContactCompliance::Value closure =
          contact.coefficients.overclosure(point, result.traction[0]);
        const double derivative = 1 / (1 + epsilon(point) * closure.derivative);
        result.by_gap[0][0]     = -epsilon(point) * derivative;
        result.by_stress[0][0]  = pressure_shift == PressureShift::normal_stress ? derivative : 0.;
        result.residual[0]      = in.gap[0] + closure.value;
        return result;
      }
    // The overclosure is evaluated at the trial pressure, so that steps of Newton's method are
    // those of p = R(p - c (g + ...)), whose derivatives are bounded, while the overclosure is none
    // of a negative pressure, and that of a small one may be steep. Divided by the derivative of R,
    // the equation is symmetric.
    const double elastic  = pressure_shift == PressureShift::none ? 1 / epsilon(point) : 0.;
    const double c        = std::min(epsilon(point), contact.coefficients.stiffness(point));
    const double distance = in.gap[0] + elastic * in.traction[0];
    const ContactCompliance::Value tried = trial_pressure(point, in.traction[0] - c * distance, c),
                                   closure = contact.coefficients.overclosure(point, tried.value);
    result.traction[0]                     = in.traction[0];
    result.residual[0]                     = (distance + closure.value) / tried.derivative;
    result.residual_by_traction[0][0]      = elastic + closure.derivative;
    return result;
  }



  // The trial value (4.8), p - c (g + p/epsilon) with c = min(epsilon, k), for pressures of an
  // earlier mesh or load step: small errors of the gap are not multiplied by a large penalty.
  PointVectors
  NormalContact::trial_from_traction(const LawInputs &in) const
  {
    if (pressure_shift == PressureShift::multiplier ||
        pressure_shift == PressureShift::normal_stress)
      return trial(in);
    return at_all_points([&](const Index i) {
      const double compliance = pressure_shift == PressureShift::none ? 1 / epsilon(i) : 0;
      const double c          = std::min(epsilon(i), contact.coefficients.stiffness(i));
      const double p          = in.traction[0](i);
      LawVector    result;
      result[0] = trial_pressure(i, p - c * (in.gap[0](i) + compliance * p), c).value;
      return result;
    });
  }
} // namespace Signorini
