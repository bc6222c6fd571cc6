#pragma once

#include <signorini/contact/discretisation/gap_operator.h>
#include <signorini/contact/methods/method.h>

namespace Signorini
{
  /// What the law is asked with at a contact point.
  struct LawInput
  {
    double gap      = 0; ///< g, positive when open
    double stress   = 0; ///< s of the bodies, positive in compression
    double pressure = 0; ///< p, if it is an unknown
  };

  /// What it says there. All is zero where it is not active.
  struct LawResponse
  {
    double pressure = 0;                 ///< p, positive in compression
    double dp_dg = 0, dp_ds = 0;         ///< of a pressure that follows [force/length^3], [-]
    double defect = 0, d_defect_d_p = 0; ///< what the gap lacks; 0 under an unknown pressure
  };

  /// The inputs at all points; refers to them.
  struct LawInputs
  {
    const LA::Vector &gap, &stress, &pressure;

    LawInput
    operator()(const dealii::types::global_dof_index i) const
    {
      return {gap(i), stress(i), pressure(i)};
    }
  };

  /// One law for all methods (pressure positive in compression, gap positive when open):
  ///
  ///   p = max(0, p^ - eps g),
  ///
  /// the active set being where the maximum is not zero; at points of pairs that never separate
  /// p = p^ - eps g, and they are always active. A pressure that is an unknown of its own has the
  /// equation g + c p = 0 there, with the compliance c = 0, or 1/eps if it is not its own p^.
  ///
  /// Points are asked one by one, and told whether they count as active: that is the choice of the
  /// strategy that looks for the set. All numbers belong to the normal direction; a law with
  /// tangential ones is another class with these questions.
  class ContactLaw
  {
  public:
    using Index = dealii::types::global_dof_index;

    /// Refers to the gap operator.
    ContactLaw(const ContactMethod &method, const GapOperator &contact);

    /// Springs on active points, p = -factor E/h g, whatever the method.
    static ContactLaw
    springs(const GapOperator &contact, double factor);

    const GapOperator &
    gap_operator() const
    {
      return contact;
    }

    /// True: the pressure is an unknown.
    bool
    is_mixed() const
    {
      return mixed;
    }

    /// True: p^ is the pressure of the last solution, see augment().
    bool
    augments() const
    {
      return predictor == Predictor::last_pressure;
    }

    /// Let p^ be that pressure from now on.
    void
    augment(const LA::Vector &pressure);

    /// Multiply eps by that, for a start far from the solution. Only where p^ is zero. True if that
    /// changes it.
    bool
    soften(const double factor)
    {
      const bool changes = factor != softness;
      softness           = factor;
      return changes;
    }

    bool
    is_soft() const
    {
      return softness < 1;
    }

    /// The factor with which no eps is above E/h; 1 where nothing is gained by that. Collective.
    double
    softest() const;

    /// p^ - eps g
    double
    trial(Index i, const LawInput &in) const;

    /// Is the point active by itself?
    bool
    pushes(const Index i, const double trial) const
    {
      return (trial > 0 || contact.permanent(i) > 0) && contact.weight(i) > 0;
    }

    LawResponse
    response(Index i, const LawInput &in, bool active) const;

    // The same of all points:

    LA::Vector
    trial(const LawInputs &in) const;

    /// The same where the pressure of a former mesh is known, to find the set that a stiff penalty,
    /// under which gaps are mere noise at first, would not show: p - c (g + p/eps) with c at most
    /// E/h, whose sign at a solution is that of p^ - eps g for any c.
    LA::Vector
    trial_from_pressure(const LawInputs &in) const;

    /// 1 where the point is active by itself, else 0.
    LA::Vector
    pushes(const LA::Vector &trial) const;

    /// An unknown one is left as it is where active.
    LA::Vector
    pressure(const LawInputs &in, const LA::Vector &active) const;

    /// As forces: times areas and E/h, or times eps if it augments, which is what the next
    /// augmentation changes.
    LA::Vector
    defect(const LawInputs &in, const LA::Vector &active) const;

  private:
    ContactLaw(const GapOperator &contact, Predictor predictor, bool mixed, double spring);

    double
    epsilon(Index i) const
    {
      return spring < 0 ? softness * contact.epsilon(i) : spring * contact.stiffness(i);
    }

    const GapOperator &contact;
    Predictor          predictor;
    bool               mixed;
    double             spring; ///< negative: the method's eps
    double             softness = 1;
    LA::Vector         last; ///< p^ of what augments
  };
} // namespace Signorini
