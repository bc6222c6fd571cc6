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
      "how contact is imposed; auto: what costs least for the Target error, and the "
      "degree of bodies, if nobody sets it");
    section.add_choice(
      "Integration",
      integration,
      or_auto(Integration::rules()),
      "of slave faces: auto: what suits the method; segments: exactly, on their intersections with master faces; by Gauss "
      "points on whole faces (cheaper); at the nodes (cheapest)");
    section.add(
      "Quadrature points",
      quadrature_points,
      "a direction on a segment or face; 0: degree + 1; degree + 3 for weighted methods on whole faces, and on segments of "
      "faces far from parallelograms, as those of divided tetrahedra; nodes have degree + 1",
      Range{0, 20});
    section.add_choice(
      "Pressure basis",
      pressure_basis,
      {{"dual", Basis::dual}, {"standard", Basis::standard}},
      "of methods that weigh the gap at slave nodes: functions biorthogonal to the displacement's (fewest Newton steps), "
      "or the displacement's own");
    section.add_choice(
      "Contact geometry",
      geometry,
      {{"automatic", ContactGeometry::automatic},
       {"reference", ContactGeometry::reference},
       {"updated", ContactGeometry::updated}},
      "where gaps and normals are taken: reference: of the surfaces at rest; updated: of the surfaces as they are now, "
      "which costs a search and a solve or two more; automatic: as they are now where that changes the pressure");
    section.add(
      "Geometry share",
      geometry_share,
      "of the pressure that automatic does not update for; it is estimated from the solution",
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
    // Nodes are those of the slave, and forces at points push its nodes: it has to follow them all.
    const bool         of_slave = rule == Rule::nodes || (rule == Rule::quadrature && !weighs);
    const unsigned int degree   = of_slave ? slave : std::max(slave, master);
    const unsigned int usual    = rule == Rule::quadrature && weighs ? degree + 3 : degree + 1;
    return {rule,
            quadrature_points == 0 || rule == Rule::nodes ? usual : quadrature_points,
            weighs ? pressure_basis : Basis::standard,
            quadrature_points == 0 ? degree + 3 : quadrature_points};
  }
} // namespace Signorini
