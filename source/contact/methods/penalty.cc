// SPDX-License-Identifier: Apache-2.0
#include "contact/methods/penalty.h"

#include <signorini/parameters/section.h>

#include <cmath>

namespace Signorini
{
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
} // namespace Signorini
