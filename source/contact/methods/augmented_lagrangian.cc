// SPDX-License-Identifier: Apache-2.0
#include "contact/methods/methods.h"
#include "contact/methods/penalty_factor.h"
#include <signorini/parameters/section.h>

#include <optional>

namespace Signorini
{
  /// Augmented Lagrangian method (doc/theory, 2.4) in two forms. Uzawa: a sequence of penalty
  /// solutions p = max(0, p^ - eps g), each of which starts from the pressure p^ of the one before,
  /// until the gap weighted at the slave nodes is closed; systems without multipliers. The gap
  /// falls by about 1/(1 + Factor) each time. Newton: displacement and pressure at once, from p =
  /// max(0, p - eps g) (Alart, Curnier, Comput. Methods Appl. Mech. Engrg. 92 (1991) 353-375). The
  /// result of both is that of the Lagrange multiplier method. With friction the bound of
  /// tangential tractions changes with each augmentation, and points at the edge of a stick zone
  /// may change their statuses for ever: Newton is the default then.
  class AugmentedLagrangian : public ContactMethod
  {
  public:
    enum class Loop
    {
      Uzawa, ///< penalty solutions one after the other
      Newton ///< displacement and pressure at once
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
      return has_multipliers() ? PressureShift::multiplier : PressureShift::last_pressure;
    }

    bool
    has_multipliers() const override
    {
      return loop.value_or(has_friction ? Loop::Newton : Loop::Uzawa) == Loop::Newton;
    }

    double
    penalty(const PenaltyScale &scale) const override
    {
      return penalty_factor.of(scale);
    }

  private:
    PenaltyFactor       penalty_factor;
    std::optional<Loop> loop; ///< empty: chosen
  };



  void
  AugmentedLagrangian::declare(Section &section)
  {
    penalty_factor.declare(
      section,
      "penalty parameter in units of E/h; a larger one needs fewer augmentations, the result does not depend on it");
    section.rename_key("Loop", "Scheme");
    section.add_choice(
      "Scheme",
      loop,
      or_auto<Loop>({{"Uzawa", Loop::Uzawa}, {"Newton", Loop::Newton}}),
      "Uzawa: a sequence of penalty solutions with updates of the multiplier; Newton: displacement and multiplier are solved simultaneously; auto: Newton with friction, else Uzawa");
  }



  std::shared_ptr<ContactMethod>
  make_augmented_lagrangian()
  {
    return std::make_shared<AugmentedLagrangian>();
  }
} // namespace Signorini
