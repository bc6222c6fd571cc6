#pragma once

#include <signorini/contact/methods/penalty_factor.h>

namespace Signorini
{
  /// Penalty method, thesis (51)-(58): p = max(0, -eps g). Bodies penetrate by p/eps.
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

    Predictor
    predictor() const override
    {
      return Predictor::none;
    }

    bool
    has_multipliers() const override
    {
      return false;
    }

    /// eps = Factor E/h (L/h)^Growth, with the size L of the scene; or Stiffness.
    double
    penalty(const PenaltyScale &scale) const override;

    Rule
    usual_integration() const override
    {
      return weighting == Weighting::mortar ? Rule::segments : Rule::quadrature;
    }

    void
    check(const Integration &integration, unsigned int degree) const override;


  private:
    PenaltyFactor penalty_factor;
    double        growth    = 0;
    Weighting     weighting = Weighting::mortar;
  };
} // namespace Signorini
