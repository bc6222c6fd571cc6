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



  // p^ - epsilon g of doc/theory, (2.1), with p^ of the method.
  LawVector
  NormalContact::trial(const Index point, const LawInput &in) const
  {
    const double predicted = pressure_shift == PressureShift::multiplier    ? in.traction[0] :
                             pressure_shift == PressureShift::normal_stress ? in.stress[0] :
                             pressure_shift == PressureShift::last_pressure ? last(point) :
                                                                              0.;
    LawVector    result;
    result[0] = predicted - epsilon(point) * in.gap[0];
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
    result.residual[0]           = in.gap[0];
    result.residual_by_gap[0][0] = 1;
    if (!multiplier)
      {
        result.traction        = trial(point, in);
        result.by_gap[0][0]    = -epsilon(point);
        result.by_stress[0][0] = pressure_shift == PressureShift::normal_stress ? 1. : 0.;
        return result;
      }
    result.traction[0] = in.traction[0];
    if (pressure_shift == PressureShift::none)
      result.residual_by_traction[0][0] = 1 / epsilon(point);
    result.residual[0] += result.residual_by_traction[0][0] * in.traction[0];
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
      result[0] = p - c * (in.gap[0](i) + compliance * p);
      return result;
    });
  }
} // namespace Signorini
