#include <signorini/contact/methods/penalty.h>
#include <signorini/parameters/section.h>

#include <cmath>

namespace Signorini
{
  void
  Penalty::declare(Section &section)
  {
    section.add(
      "Factor",
      penalty_factor,
      "penalty in units of E/h: larger is more exact, the penetration is p h / (Factor E)",
      Range{0, 1e12, false});
    section.add(
      "Growth",
      growth,
      "times (L/h)^Growth, L the size of the scene: 1 keeps the order of degree 2 when the "
      "mesh is refined, -1 is a penalty that does not depend on the mesh",
      Range{-2, 3});
    section.add_choice("Weighting",
                       weighting,
                       {"mortar", "pointwise"},
                       "penalise the gap weighted at the slave nodes, or at each quadrature point");
  }



  double
  Penalty::penalty(const PenaltyScale &scale) const
  {
    return penalty_factor * scale.stiffness * std::pow(scale.fineness, growth);
  }



  void
  Penalty::check(const Integration &integration, const unsigned int degree) const
  {
    constexpr double largest_factor = 10; // peaks of 3 % seen with it in Hertz contact, 8 % with 30
    if (weighting == "mortar" || integration.rule == "nodes" || penalty_factor <= largest_factor)
      return;
    const bool segments = integration.rule == "segments";
    if (segments || integration.n_points > degree + 1)
      throw SceneError(
        "Contact method/Integration = " + integration.rule +
        (segments ? "" : ", Quadrature points = " + std::to_string(integration.n_points)) +
        " penalises more points of a face than the displacement can follow: with a Factor above 10 "
        "the pressure would oscillate; take Weighting = mortar, or Integration = quadrature with "
        "Quadrature points = 0");
  }
} // namespace Signorini
