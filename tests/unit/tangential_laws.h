// SPDX-License-Identifier: Apache-2.0
// Contact laws with tangential tractions, for tests of all that acts on points and statuses.
#pragma once

#include "contact/laws/contact_law.h"
#include <signorini/contact/methods/method.h>

namespace TestScene
{
  using namespace Signorini;
  using namespace dealii;

  /// Springs against gap and slip at closed points, p = -normal g and t = -tangential s.
  class TangentialSprings : public ContactLaw
  {
  public:
    TangentialSprings(const GapOperator &contact, const double normal, const double tangential)
      : ContactLaw(contact)
      , normal(normal)
      , tangential(tangential)
    {}

    bool
    has_multiplier() const override
    {
      return false;
    }

    using ContactLaw::status;
    using ContactLaw::trial;

    LawVector
    trial(const Index, const LawInput &in) const override
    {
      LawVector result = -tangential * in.gap;
      result[0]        = -normal * in.gap[0];
      return result;
    }

    ContactStatus
    status(const Index, const LawVector &trial) const override
    {
      return trial[0] > 0 ? ContactStatus::stick : ContactStatus::open;
    }

    LawResponse
    response(const Index i, const LawInput &in, const ContactStatus status) const override
    {
      LawResponse result;
      if (status == ContactStatus::open)
        return result;
      result.traction = trial(i, in);
      for (unsigned int a = 0; a < n_components(); ++a)
        result.by_gap[a][a] = a == 0 ? -normal : -tangential;
      return result;
    }

  private:
    const double normal, tangential;
  };

  /// A sliding element with a memory: at closed points p = (-normal g)+, or an unknown with g = 0,
  /// and t = -friction p m along the unit vector m of the slip of the load step before, none at the
  /// first one. Its tangent has no symmetry.
  class Drag : public ContactLaw
  {
  public:
    Drag(const GapOperator &contact,
         const double       normal,
         const double       friction,
         const bool         multiplier)
      : ContactLaw(contact)
      , normal(normal)
      , friction(friction)
      , multiplier(multiplier)
    {}

    bool
    has_multiplier() const override
    {
      return multiplier;
    }

    bool
    is_symmetric() const override
    {
      return false;
    }

    /// They depend on internal variables.
    bool
    has_constant_derivatives() const override
    {
      return false;
    }

    InternalVariables
    initial_variables() const override
    {
      return {{LawVector()}, {0.}}; // the slip of the last load step; steps that were closed
    }

    using ContactLaw::status;
    using ContactLaw::trial;

    LawVector
    trial(const Index i, const LawInput &in) const override
    {
      const double p      = (multiplier ? in.traction[0] : 0.) - normal * in.gap[0];
      LawVector    result = -friction * p * direction(in);
      result[0]           = p;
      return contact.weight(i) > 0 ? result : LawVector();
    }

    ContactStatus
    status(const Index, const LawVector &trial) const override
    {
      return trial[0] > 0 ? ContactStatus::slip : ContactStatus::open;
    }

    LawResponse
    response(const Index i, const LawInput &in, const ContactStatus status) const override
    {
      LawResponse result;
      result.internal = initial_variables();
      if (status == ContactStatus::open)
        return result;
      const LawVector    m = direction(in);
      const unsigned int n = n_components();
      for (unsigned int a = 1; a < n; ++a)
        result.internal.vectors[0][a] = in.gap[a];
      result.internal.scalars[0]   = in.internal.scalars[0] + 1;
      result.residual[0]           = in.gap[0];
      result.residual_by_gap[0][0] = 1;
      if (!multiplier)
        {
          result.traction     = trial(i, in);
          result.by_gap[0][0] = -normal;
          for (unsigned int a = 1; a < n; ++a)
            result.by_gap[a][0] = friction * normal * m[a];
          return result;
        }
      result.traction = in.traction;
      for (unsigned int a = 1; a < n; ++a)
        {
          result.residual[a] = (in.traction[a] + friction * in.traction[0] * m[a]) / normal;
          result.residual_by_traction[a][a] = 1 / normal;
          result.residual_by_traction[a][0] = friction * m[a] / normal;
        }
      return result;
    }

  private:
    static LawVector
    direction(const LawInput &in)
    {
      const LawVector &slip = in.internal.vectors[0];
      const double     size = slip.norm();
      return size > 1e-12 ? slip / size : LawVector();
    }

    const double normal, friction;
    const bool   multiplier;
  };

  /// Makes one of these laws.
  class TangentialMethod : public ContactMethod
  {
  public:
    enum Kind
    {
      springs,
      drag,
      drag_multiplier
    };

    TangentialMethod(const Kind     kind,
                     const Sampling sampling,
                     const double   normal,
                     const double   tangential)
      : kind(kind)
      , my_sampling(sampling)
      , normal(normal)
      , tangential(tangential)
    {}

    void
    declare(Section &) override
    {}

    Sampling
    sampling() const override
    {
      return my_sampling;
    }

    PressureShift
    pressure_shift() const override
    {
      return kind == drag_multiplier ? PressureShift::multiplier : PressureShift::none;
    }

    bool
    has_multipliers() const override
    {
      return kind == drag_multiplier;
    }

    double
    penalty(const PenaltyScale &) const override
    {
      return normal;
    }

    std::unique_ptr<ContactLaw>
    make_law(const GapOperator &contact) const override
    {
      if (kind == springs)
        return std::make_unique<TangentialSprings>(contact, normal, tangential);
      return std::make_unique<Drag>(contact, normal, tangential, kind == drag_multiplier);
    }

    bool
    uses_slip() const override
    {
      return true;
    }

  private:
    const Kind     kind;
    const Sampling my_sampling;
    const double   normal, tangential;
  };
} // namespace TestScene
