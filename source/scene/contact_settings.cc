// SPDX-License-Identifier: Apache-2.0
#include "scene/descriptions.h"
#include <signorini/parameters/section.h>
#include <signorini/scene/contact_settings.h>

#include <algorithm>

namespace Signorini
{
  ContactSettings::ContactSettings()
  {
    for (const std::string &name : method_names())
      methods.emplace_back(name, ContactMethod::create(name));
  }



  bool
  ContactSettings::is_automatic() const
  {
    return method == "auto";
  }



  // The default method is the one that is taken for "auto".
  std::string
  ContactSettings::chosen_name() const
  {
    return is_automatic() ? ContactSettings().method : method;
  }



  const ContactMethod &
  ContactSettings::chosen() const
  {
    return *std::find_if(methods.begin(), methods.end(), [&](const auto &m) {
              return m.first == chosen_name();
            })->second;
  }



  void
  ContactSettings::declare(Section &section)
  {
    std::vector<std::string> choices = method_names();
    choices.emplace_back("auto");
    section.add_choice(
      "Method",
      method,
      choices,
      "how the contact constraints are enforced; auto: the method of least cost for the "
      "Accuracy/Target error, and the polynomial degree of the bodies, if it is not set");
    section.add_choice(
      "Integration",
      integration,
      or_auto(Integration::rules()),
      "numerical integration on slave faces: auto: the rule that suits the method; segments: exact, on the intersections "
      "with master faces; quadrature: Gauss points on whole faces (cheaper); nodes: at the slave nodes (cheapest)");
    section.add(
      "Quadrature points",
      quadrature_points,
      "Gauss points per direction on a segment or face; 0: degree + 1, but degree + 3 for mortar methods on whole faces and "
      "on segments of strongly distorted faces, as those of subdivided tetrahedra; Integration = nodes uses degree + 1",
      Range{0, 20});
    section.add_choice(
      "Pressure basis",
      pressure_basis,
      {{"dual", Basis::dual}, {"standard", Basis::standard}},
      "of mortar methods: dual: multiplier functions biorthogonal to the displacement shape functions (fewest Newton "
      "steps); standard: the displacement shape functions");
    section.add_choice(
      "Contact geometry",
      geometry,
      {{"automatic", ContactGeometry::automatic},
       {"reference", ContactGeometry::reference},
       {"updated", ContactGeometry::updated}},
      "configuration in which gaps and normals are computed: reference: undeformed (small sliding); updated: current (large "
      "sliding), which costs one or two more searches and solves; automatic: updated if that changes the pressure by "
      "more than the Geometry update tolerance");
    section.rename_key("Geometry share", "Geometry update tolerance");
    section.add("Geometry update tolerance",
                geometry_share,
                "relative change of the pressure, estimated from the solution, above which "
                "Contact geometry = automatic changes to updated",
                Range{0, 1, false});
    for (const auto &[name, object] : methods)
      section.add_section(name, about_method(name), [&, object = object](Section &s) {
        object->declare(s);
      });
  }



  Integration
  ContactSettings::integration_of_degrees(const unsigned int slave, const unsigned int master) const
  {
    const Rule rule   = integration.value_or(chosen().usual_integration());
    const bool weighs = chosen().sampling() == Sampling::nodes;
    // The number of points follows from the degree of the slave alone where its nodes are sampled,
    // or where forces at points act on its nodes, which have to resolve them; otherwise from the
    // larger degree of both bodies.
    const bool         of_slave = rule == Rule::nodes || (rule == Rule::quadrature && !weighs);
    const unsigned int degree   = of_slave ? slave : std::max(slave, master);
    const unsigned int usual    = rule == Rule::quadrature && weighs ? degree + 3 : degree + 1;
    return {rule,
            quadrature_points == 0 || rule == Rule::nodes ? usual : quadrature_points,
            weighs ? pressure_basis : Basis::standard,
            quadrature_points == 0 ? degree + 3 : quadrature_points};
  }
} // namespace Signorini
