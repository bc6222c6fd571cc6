#include "contact/methods/penalty.h"

#include <signorini/parameters/section.h>

#include <cmath>

namespace Signorini
{
  void
  Penalty::declare(Section &section)
  {
    penalty_factor.declare(
      section,
      "penalty in units of E/h: larger is more exact, the penetration is p h / (Factor E)");
    section.add(
      "Growth",
      growth,
      "times (L/h)^Growth, L the size of the scene: 1 keeps the order of degree 2 when the "
      "mesh is refined, -1 is a penalty that does not depend on the mesh",
      Range{-2, 3});
    section.add_choice("Weighting",
                       weighting,
                       {{"mortar", Weighting::mortar}, {"pointwise", Weighting::pointwise}},
                       "penalise the gap weighted at the slave nodes, or at each quadrature point");
    if (section.reading() && penalty_factor.is_absolute() && growth != 0)
      section.fail("Growth", "belongs to a Factor; a Stiffness does not change with the mesh");
  }



  double
  Penalty::penalty(const PenaltyScale &scale) const
  {
    return penalty_factor.of(scale) * std::pow(scale.fineness, growth);
  }



  void
  Penalty::check(const Integration &integration, const unsigned int degree) const
  {
    if (weighting == Weighting::mortar || integration.rule == Rule::nodes || is_soft())
      return;
    const bool segments = integration.rule == Rule::segments;
    if (segments || integration.n_points > degree + 1)
      throw SceneError(
        "Contact method/Integration = " + word_of(Integration::rules(), integration.rule) +
        (segments ? "" : ", Quadrature points = " + std::to_string(integration.n_points)) +
        " penalises more points of a face than the displacement can follow: with a Factor above 10 or "
        "a Stiffness the pressure would oscillate; take Weighting = mortar, or Integration = quadrature with "
        "Quadrature points = 0");
  }
} // namespace Signorini
