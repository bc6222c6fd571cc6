// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/laws/normal_contact.h"

namespace Signorini
{
  /// Coulomb friction upon normal contact, one law for all methods: with the slip s of the load
  /// step, the bound r(p), mu p in the simplest case, and the projection Pi onto the disc |t| <= r,
  ///
  ///   t = Pi(t^ - c s),
  ///
  /// where t^ is chosen like p^ of the normal law: the traction itself, if it is an unknown; the
  /// tangential stress of the bodies (Nitsche); the traction of the last augmentation (Uzawa); and
  /// otherwise the traction t_n at the end of the last load step, with c = eps, so that the law is
  /// the return mapping of an elastic slip. The latter is solved with the traction as an unknown as
  /// well: s is then the slip beyond the elastic one, s + (t - t_n)/eps. A point sticks where
  /// t^ - c s is inside the disc, else it slips. If the traction is an unknown, the equation is
  /// (t - Pi(t^ - c s))/c = 0: s = 0 where it sticks, and the solution does not depend on c (Alart,
  /// Curnier, Comput. Methods Appl. Mech. Engrg. 92 (1991) 353-375; Hueber, Stadler, Wohlmuth, SIAM
  /// J. Sci. Comput. 30 (2008) 572-596). Points of tied pairs stick whatever their traction,
  /// as long as their bond is intact.
  ///
  /// With a tangential compliance e of the interface the slip that remains to be zero where points
  /// stick is s + e (t - t_n), so that t = Pi((t^ - c s + c e t_n)/(1 + c e)).
  ///
  /// The internal variables are, at the end of the last load step: the tangential traction (vector
  /// 0); the slip since the point came into contact (vector 1) [length]; with Nitsche's method the
  /// tangential stress (vector 2); the work per area that friction has taken from the
  /// bodies (scalar 0) [force/length]; and the length of the path of slip (scalar 1) [length]. The
  /// latter two are those of (t - (t^ - c s))/c, the slip without the elastic one of penalties, or
  /// that of the discretisation with Nitsche's method: the work is not negative. A point that opens
  /// keeps the scalars only. Where bonds can fail, scalar 2 is 1 at points whose bond is intact,
  /// else 0 (BondStrength). Where ties begin late, scalar 3 is the normal gap at their beginning
  /// [length], and scalar 4 is 1 where that is known, else 0. The law keeps these three, and the
  /// driver changes them.
  class CoulombFriction : public ContactLaw
  {
  public:
    /// The number of the internal scalar that tells whether a bond is intact.
    static constexpr unsigned int bond = 2;
    /// Those of the gap at the beginning of a tie, and whether it is known.
    static constexpr unsigned int gap_at_start = 3, gap_is_known = 4;

    /// Keeps a reference to the gap operator, whose coefficients contain mu.
    CoulombFriction(const ContactMethod &method, const GapOperator &contact);

    bool
    has_multiplier() const override
    {
      return normal.has_multiplier();
    }

    /// The tangential traction of slipping points depends on the pressure, but not the pressure on
    /// the slip.
    bool
    is_symmetric() const override
    {
      return !has_friction;
    }

    /// At slipping points they depend on the direction of slip.
    bool
    has_constant_derivatives() const override
    {
      return !has_friction && normal.has_constant_derivatives();
    }

    InternalVariables
    initial_variables() const override
    {
      InternalVariables result{std::vector<LawVector>(shift == PressureShift::normal_stress ? 3 :
                                                                                              2),
                               {0., 0.}};
      if (has_strength || has_late_ties)
        result.scalars.push_back(1);
      if (has_late_ties)
        result.scalars.insert(result.scalars.end(), 2, 0.);
      return result;
    }

    bool
    augments() const override
    {
      return normal.augments();
    }

    void
    augment(const PointVectors &traction) override
    {
      normal.augment(traction);
      last = traction;
    }

    bool
    scale_penalty(const double factor) override
    {
      return normal.scale_penalty(factor);
    }

    bool
    has_scaled_penalty() const override
    {
      return normal.has_scaled_penalty();
    }

    double
    minimal_penalty_scale() const override
    {
      return normal.minimal_penalty_scale();
    }

    bool
    give_friction_bound(const bool given) override
    {
      has_given_bound = given;
      return true;
    }

    double
    residual_stiffness(const Index point) const override
    {
      return normal.residual_stiffness(point);
    }

    using ContactLaw::status;
    using ContactLaw::trial;

    /// Trial pressure and trial tangential traction t^ - eps s.
    LawVector
    trial(Index point, const LawInput &in) const override;

    /// Open where the normal law is; else stick if the trial traction is inside the disc of the
    /// trial pressure, or on its rim up to rounding. Without friction points slip.
    ContactStatus
    status(Index point, const LawVector &trial) const override;

    /// Normal components as those of NormalContact, tangential ones as trial().
    PointVectors
    trial_from_traction(const LawInputs &in) const override;

    LawResponse
    response(Index point, const LawInput &in, ContactStatus status) const override;

  private:
    /// The parameter c of the tangential part [force/length^3].
    double
    parameter(Index point) const;

    /// 1/eps where tractions are unknowns of a penalty law, else 0 [length^3/force].
    double
    elastic_compliance(Index point) const;

    /// The same for the slip, and that of the interface.
    double
    tangential_compliance(const Index point) const
    {
      return elastic_compliance(point) + contact.coefficients.tangential_compliance(point);
    }

    /// A tangential component of t^.
    double
    predicted(Index point, const LawInput &in, unsigned int component) const;

    const bool    has_friction;  ///< at any point; else points of tied pairs stick, others slip
    const bool    has_strength;  ///< whether bonds of tied pairs can fail
    const bool    has_late_ties; ///< whether tied pairs begin after the start of the history
    NormalContact normal;
    const PressureShift shift;
    PointVectors        last;                    ///< traction of the last augmentation
    bool                has_given_bound = false; ///< see give_friction_bound()
  };
} // namespace Signorini
