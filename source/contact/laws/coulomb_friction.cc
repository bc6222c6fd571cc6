// SPDX-License-Identifier: Apache-2.0
#include "contact/laws/coulomb_friction.h"

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Elastic slip where tractions are unknowns, relative to traction/epsilon.
    constexpr double compliance = 1e-10;

    /// The tangential part of a vector at a point.
    LawVector
    tangential(LawVector v)
    {
      v[0] = 0;
      return v;
    }

    /// A projection of a trial traction onto the disc of friction, and its derivatives.
    struct DiscProjection
    {
      LawVector traction;
      LawMatrix by_trial; ///< [a][b], column 0 by the trial pressure, which sets the radius
    };

    /// The projection for a given status: the identity where the point sticks; else r m along the
    /// unit vector m of the trial traction, whose derivative is r/|t| (I - m m), and by the
    /// pressure dr/dp m. A trial traction without direction, and a trial pressure that is tensile,
    /// give no tangential traction.
    DiscProjection
    project(const LawVector                          &trial,
            const ContactCoefficients::FrictionBound &radius,
            const ContactStatus                       status)
    {
      DiscProjection  result;
      const LawVector t    = tangential(trial);
      const double    size = t.norm();
      if (status == ContactStatus::stick)
        {
          result.traction = t;
          for (unsigned int a = 1; a < 3; ++a)
            result.by_trial[a][a] = 1;
          return result;
        }
      if (trial[0] <= 0 || size == 0)
        return result;
      const LawVector m = t / size;
      result.traction   = radius.value * m;
      for (unsigned int a = 1; a < 3; ++a)
        {
          result.by_trial[a][0] = radius.by_pressure * m[a];
          for (unsigned int b = 1; b < 3; ++b)
            result.by_trial[a][b] = radius.value / size * ((a == b ? 1. : 0.) - m[a] * m[b]);
        }
      return result;
    }
  } // namespace



  CoulombFriction::CoulombFriction(const ContactMethod &method, const GapOperator &contact)
    : ContactLaw(contact)
    , has_friction(method.has_friction)
    , has_strength(method.has_strength)
    , has_late_ties(method.has_late_ties)
    , normal(method, contact)
    , shift(method.pressure_shift())
    , last(contact.zeros())
  {}



  // Any parameter of the size of E/h is good for an unknown traction; stiffer ones turn small slips
  // of an iterate into large trial tractions of all directions.
  double
  CoulombFriction::parameter(const Index point) const
  {
    const double epsilon = normal.epsilon(point);
    return has_multiplier() ? std::min(epsilon, contact.coefficients.stiffness(point)) : epsilon;
  }



  double
  CoulombFriction::elastic_compliance(const Index point) const
  {
    return has_multiplier() && shift == PressureShift::none ? 1 / normal.epsilon(point) : 0.;
  }



  // With Nitsche's method sticking points keep the difference of stress and traction, whose slip
  // would otherwise be made anew in each load step: bodies at rest would creep.
  double
  CoulombFriction::predicted(const Index point, const LawInput &in, const unsigned int a) const
  {
    const double before = in.internal.vectors[0][a];
    return has_multiplier() ? in.traction[a] :
           shift == PressureShift::normal_stress ?
                              before + in.stress[a] - in.internal.vectors[2][a] :
           shift == PressureShift::last_pressure ? last[a](point) :
                                                   before;
  }



  LawVector
  CoulombFriction::trial(const Index point, const LawInput &in) const
  {
    LawVector    result = normal.trial(point, in);
    const double c      = parameter(point);
    if (has_multiplier())
      {
        const double rigid =
          in.traction[0] - c * (in.gap[0] + elastic_compliance(point) * in.traction[0]);
        result[0] = normal.trial_pressure(point, rigid, c).value;
      }
    const double elastic = tangential_compliance(point);
    for (unsigned int a = 1; a < n_components(); ++a)
      {
        const double before = in.internal.vectors[0][a],
                     now    = predicted(point, in, a) - c * in.gap[a];
        // The slip of an unknown traction with compliance is that beyond the elastic one. A
        // traction that follows from the law is on both sides of the equation.
        result[a] = has_multiplier() ? now - c * elastic * (in.traction[a] - before) :
                                       (now + c * elastic * before) / (1 + c * elastic);
      }
    return result;
  }



  ContactStatus
  CoulombFriction::status(const Index point, const LawVector &trial) const
  {
    const ContactStatus least = status_of(contact.coefficients.least_status(point));
    if (normal.status(point, trial) == ContactStatus::open || least == ContactStatus::stick)
      return least;
    // At the start of a load step the traction of points that slipped before is on the rim, and
    // there is no slip yet: rounding must not decide, and they stick first.
    constexpr double rounding = 1e-9;
    const double     radius   = contact.coefficients.friction_bound(point, trial[0]).value;
    return contact.coefficients.friction(point) > 0 &&
               tangential(trial).norm() <= (1 + rounding) * radius ?
             ContactStatus::stick :
             ContactStatus::slip;
  }



  PointVectors
  CoulombFriction::trial_from_traction(const LawInputs &in) const
  {
    PointVectors result = trial(in);
    result[0]           = normal.trial_from_traction(in)[0];
    return result;
  }



  // Where supports leave no slip, for example at a plane of symmetry, rows of the slip are zero and
  // the traction along them is undetermined: a compliance far below the accuracy of solutions makes
  // it zero.
  //
  // The chain rule: the trial depends on gap and slip by -c, and on an unknown traction by 1, less
  // c times its elastic compliance.
  LawResponse
  CoulombFriction::response(const Index point, const LawInput &in, const ContactStatus status) const
  {
    LawResponse result      = normal.response(point, in, status);
    result.internal         = initial_variables();
    result.internal.scalars = in.internal.scalars;
    if (status == ContactStatus::open)
      return result;

    const unsigned int                 n     = n_components();
    const double                       c     = parameter(point);
    const LawVector                    tried = trial(point, in);
    ContactCoefficients::FrictionBound radius =
      contact.coefficients.friction_bound(point, tried[0]);
    if (has_given_bound)
      radius.by_pressure = 0;
    const DiscProjection allowed = project(tried, radius, status);
    // Derivatives of trial components by that of a rigid interface, and of the latter by an unknown
    // traction.
    const double elastic = tangential_compliance(point);
    LawVector    of_rigid, by_traction;
    for (unsigned int b = 0; b < n; ++b)
      {
        of_rigid[b]    = b == 0 ?
                           1 / (1 + c * contact.coefficients.overclosure(point, tried[0]).derivative) :
                         has_multiplier() ? 1. :
                                            1 / (1 + c * elastic);
        by_traction[b] = 1 - c * (b == 0 ? elastic_compliance(point) : elastic);
      }
    double slip = 0;
    for (unsigned int a = 1; a < n; ++a)
      {
        // Without a multiplier the residual is what the next augmentation changes.
        result.traction[a]            = has_multiplier() ? in.traction[a] : allowed.traction[a];
        result.residual[a]            = (predicted(point, in, a) - allowed.traction[a]) / c;
        result.internal.vectors[0][a] = result.traction[a];
        result.internal.vectors[1][a] = in.internal.vectors[1][a] + in.gap[a];
        if (shift == PressureShift::normal_stress)
          result.internal.vectors[2][a] = in.stress[a];
        // The slip but for elastic slip, along the projection: zero where the point sticks.
        const double lost = (result.traction[a] - tried[a]) / (c * of_rigid[a]);
        result.internal.scalars[0] -= result.traction[a] * lost;
        slip = std::hypot(slip, lost);
        for (unsigned int b = 0; b < n; ++b)
          {
            const double by_trial        = allowed.by_trial[a][b] * of_rigid[b];
            result.residual_by_gap[a][b] = by_trial;
            if (!has_multiplier())
              {
                result.by_gap[a][b]    = -c * by_trial;
                result.by_stress[a][b] = shift == PressureShift::normal_stress ? by_trial : 0;
                continue;
              }
            result.residual_by_traction[a][b] =
              ((a == b ? 1. : 0.) - by_trial * by_traction[b]) / c;
          }
        if (has_multiplier() && elastic == 0)
          {
            result.residual[a] += compliance * in.traction[a] / c;
            result.residual_by_traction[a][a] += compliance / c;
          }
      }
    if (status == ContactStatus::slip)
      result.internal.scalars[1] += slip;
    return result;
  }
} // namespace Signorini
