#pragma once

#include <signorini/contact/method.h>

namespace Signorini
{
  /// Penalty method, thesis (51)-(58): p = max(0, -eps g). Bodies penetrate by p/eps.
  class Penalty : public ContactMethod
  {
  public:
    void
    declare(Section &section) override;

    Sampling
    sampling() const override
    {
      return weighting == "mortar" ? Sampling::nodes : Sampling::quadrature_points;
    }

    bool
    has_multipliers() const override
    {
      return false;
    }

    double
    factor() const override
    {
      return penalty_factor;
    }

  private:
    double      penalty_factor = 1000;
    std::string weighting      = "mortar";
  };
} // namespace Signorini
