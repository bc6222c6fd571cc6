// SPDX-License-Identifier: Apache-2.0
#include "contact/methods/methods.h"
#include "contact/methods/penalty_factor.h"
#include <signorini/parameters/section.h>

namespace Signorini
{
  /// Perturbed Lagrangian method (doc/theory, 2.3): the pressure is an unknown as in the Lagrange
  /// multiplier method, but the contact is elastic: g + p/eps = 0 at the slave nodes where it acts.
  /// As a block system it is a saddle point that large factors do not hurt. Condensed, the pressure
  /// is eliminated, which yields the penalty method with mortar weighting, with the same solution.
  class PerturbedLagrangian : public ContactMethod
  {
  public:
    enum class Form
    {
      block,    ///< the pressure is an unknown
      condensed ///< it is eliminated
    };

    void
    declare(Section &section) override;

    Sampling
    sampling() const override
    {
      return Sampling::nodes;
    }

    PressureShift
    pressure_shift() const override
    {
      return PressureShift::none;
    }

    bool
    has_multipliers() const override
    {
      return form == Form::block;
    }

    double
    penalty(const PenaltyScale &scale) const override
    {
      return penalty_factor.of(scale);
    }

  private:
    PenaltyFactor penalty_factor;
    Form          form = Form::block;
  };



  void
  PerturbedLagrangian::declare(Section &section)
  {
    penalty_factor.declare(
      section,
      "penalty parameter (contact stiffness) in units of E/h; the penetration is p h / (Factor E)");
    section.rename_key("Form", "System");
    section.rename_choice("System", "block", "saddle point");
    section.add_choice("System",
                       form,
                       {{"saddle point", Form::block}, {"condensed", Form::condensed}},
                       "saddle point: the pressure is an unknown; condensed: it is eliminated");
  }



  std::shared_ptr<ContactMethod>
  make_perturbed_lagrangian()
  {
    return std::make_shared<PerturbedLagrangian>();
  }
} // namespace Signorini
