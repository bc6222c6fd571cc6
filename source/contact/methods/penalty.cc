// SPDX-License-Identifier: Apache-2.0
#include "contact/methods/methods.h"
#include "contact/methods/penalty_factor.h"
#include <signorini/parameters/section.h>

#include <cmath>

namespace Signorini
{
  /// Penalty method (doc/theory, 2.2): p = max(0, -eps g). Bodies penetrate by p/eps.
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

    PressureShift
    pressure_shift() const override
    {
      return PressureShift::none;
    }

    /// With friction the tractions are unknowns with the compliance 1/eps: trial tractions of a
    /// stiff penalty have all directions while Newton's method iterates.
    bool
    has_multipliers() const override
    {
      return has_friction;
    }

    /// eps = Factor E/h (L/h)^a with the exponent a of `Mesh size exponent` and the size L of the
    /// scene; or Stiffness.
    double
    penalty(const PenaltyScale &scale) const override;

    /// Segments, if the displacement can follow: by few points of faces that do not match,
    /// pressures swing more than by many, the more so beside hanging nodes.
    Rule
    usual_integration() const override
    {
      return weighting == Weighting::mortar || is_low_penalty() ? Rule::segments : Rule::quadrature;
    }

    void
    check(const Integration &integration, unsigned int degree) const override;


  private:
    /// Soft enough for more points of a face than it has nodes.
    bool
    is_low_penalty() const
    {
      // With this factor the pressure of Hertz contact has peaks of 3 %, with 30 it has peaks of 8
      // %.
      constexpr double largest = 10;
      return !penalty_factor.is_absolute() && penalty_factor.factor <= largest;
    }

    PenaltyFactor penalty_factor;
    double        growth    = 0;
    Weighting     weighting = Weighting::mortar;
  };



  void
  Penalty::declare(Section &section)
  {
    penalty_factor.declare(
      section, "penalty parameter in units of E/h; the penetration is p h / (Factor E)");
    section.rename_key("Growth", "Mesh size exponent");
    section.add(
      "Mesh size exponent",
      growth,
      "exponent a of the factor (L/h)^a of the penalty, L is the size of the model: 1 keeps the convergence "
      "order of degree 2, -1 makes the penalty independent of the mesh",
      Range{-2, 3});
    section.add_choice(
      "Weighting",
      weighting,
      {{"mortar", Weighting::mortar}, {"pointwise", Weighting::pointwise}},
      "mortar: penalise the weighted gap of each slave node; pointwise: penalise the gap at each quadrature point");
    if (section.reading() && penalty_factor.is_absolute() && growth != 0)
      section.fail("Mesh size exponent",
                   "has no effect on a Stiffness, which does not depend on the mesh; set Factor "
                   "instead of Stiffness, or remove this key");
  }



  // epsilon = c k (L/h)^beta (doc/theory, (2.2)).
  double
  Penalty::penalty(const PenaltyScale &scale) const
  {
    return penalty_factor.of(scale) * std::pow(scale.fineness, growth);
  }



  // More penalty constraints on a face than it has displacement nodes over-constrain it, unless the
  // penalty is low (doc/theory, 2.2).
  void
  Penalty::check(const Integration &integration, const unsigned int degree) const
  {
    if (weighting == Weighting::mortar || integration.rule == Rule::nodes || is_low_penalty())
      return;
    const bool segments = integration.rule == Rule::segments;
    if (segments || integration.n_points > degree + 1)
      throw SceneError(
        "Contact method/Integration = " + word_of(Integration::rules(), integration.rule) +
        (segments ? "" : ", Quadrature points = " + std::to_string(integration.n_points)) +
        " with Weighting = pointwise over-constrains the faces: with a Factor above 10 or a Stiffness the "
        "pressure would oscillate; set Weighting = mortar, or Integration = quadrature with Quadrature points = 0");
  }



  std::shared_ptr<ContactMethod>
  make_penalty()
  {
    return std::make_shared<Penalty>();
  }
} // namespace Signorini
