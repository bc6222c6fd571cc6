// SPDX-License-Identifier: Apache-2.0
#include "accuracy/quantities/kinds.h"
#include <signorini/base/scene_error.h>
#include <signorini/base/text.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  namespace
  {
    /// The part of the model to which a quantity belongs.
    enum class QuantityTarget
    {
      pair,
      support,
      obstacle,
      body,
      /// A point in a body.
      probe,
      /// A point on a contact pair.
      surface_probe,
      nothing
    };

    /// Whether a quantity has components.
    enum class ComponentKind
    {
      none,
      /// One of x, y, z, or none for the norm.
      vector,
      /// One of xx, yy, zz, xy, yz, xz.
      tensor
    };

    /// A kind of quantity, with the functions that evaluate it.
    struct Kind
    {
      const char    *what;
      QuantityTarget of;
      ComponentKind  components;
      Functional (*in_2d)(const QuantityName &, const Snapshot<2> &, const Probes<2> &);
      Functional (*in_3d)(const QuantityName &, const Snapshot<3> &, const Probes<3> &);
    };

    /// @return the registry: new kinds of quantities are added here.
    const std::vector<Kind> &
    kinds()
    {
      static const std::vector<Kind> all = {
        {"force", QuantityTarget::pair, ComponentKind::vector, pair_force<2>, pair_force<3>},
        {"normal force",
         QuantityTarget::pair,
         ComponentKind::none,
         normal_force<2>,
         normal_force<3>},
        {"mean pressure",
         QuantityTarget::pair,
         ComponentKind::none,
         mean_pressure<2>,
         mean_pressure<3>},
        {"largest pressure",
         QuantityTarget::pair,
         ComponentKind::none,
         largest_pressure<2>,
         largest_pressure<3>},
        {"contact area",
         QuantityTarget::pair,
         ComponentKind::none,
         contact_area<2>,
         contact_area<3>},
        {"half-width", QuantityTarget::pair, ComponentKind::none, half_width<2>, half_width<3>},
        {"contact radius",
         QuantityTarget::pair,
         ComponentKind::none,
         contact_radius<2>,
         contact_radius<3>},
        {"friction force",
         QuantityTarget::pair,
         ComponentKind::vector,
         friction_force<2>,
         friction_force<3>},
        {"stick area", QuantityTarget::pair, ComponentKind::none, stick_area<2>, stick_area<3>},
        {"largest slip",
         QuantityTarget::pair,
         ComponentKind::none,
         largest_slip<2>,
         largest_slip<3>},
        {"friction work",
         QuantityTarget::pair,
         ComponentKind::none,
         friction_work<2>,
         friction_work<3>},
        {"reaction", QuantityTarget::support, ComponentKind::vector, reaction<2>, reaction<3>},
        {"motion", QuantityTarget::obstacle, ComponentKind::vector, motion<2>, motion<3>},
        {"displacement",
         QuantityTarget::probe,
         ComponentKind::vector,
         probe_displacement<2>,
         probe_displacement<3>},
        {"stress", QuantityTarget::probe, ComponentKind::tensor, probe_stress<2>, probe_stress<3>},
        {"von Mises",
         QuantityTarget::probe,
         ComponentKind::none,
         probe_von_mises<2>,
         probe_von_mises<3>},
        {"largest von Mises",
         QuantityTarget::body,
         ComponentKind::none,
         largest_von_mises<2>,
         largest_von_mises<3>},
        {"pressure",
         QuantityTarget::surface_probe,
         ComponentKind::none,
         probe_pressure<2>,
         probe_pressure<3>},
        {"energy", QuantityTarget::nothing, ComponentKind::none, energy<2>, energy<3>}};
      return all;
    }

    /// @return the kind with a name; null if there is none.
    const Kind *
    find_kind(const std::string &what)
    {
      const auto found = std::find_if(kinds().begin(), kinds().end(), [&](const Kind &kind) {
        return kind.what == what;
      });
      return found == kinds().end() ? nullptr : &*found;
    }

    /// @return the names of the components that a kind has.
    std::vector<std::string>
    possible_components(const Kind &kind, const int dim)
    {
      if (kind.components == ComponentKind::none)
        return {};
      if (kind.components == ComponentKind::tensor)
        return {"xx", "yy", "zz", "xy", "yz", "xz"};
      return dim == 2 ? std::vector<std::string>{"x", "y"} :
                        std::vector<std::string>{"x", "y", "z"};
    }

    /// @return all kinds as a text for messages.
    std::string
    examples()
    {
      std::vector<std::string> all;
      for (const Kind &kind : kinds())
        all.push_back(std::string(kind.what) +
                      (kind.of == QuantityTarget::pair          ? " of PAIR" :
                       kind.of == QuantityTarget::support       ? " of SUPPORT" :
                       kind.of == QuantityTarget::obstacle      ? " of OBSTACLE" :
                       kind.of == QuantityTarget::body          ? " of BODY" :
                       kind.of == QuantityTarget::probe         ? " of PROBE" :
                       kind.of == QuantityTarget::surface_probe ? " of PROBE (on a pair)" :
                                                                  ""));
      return join(all);
    }
  } // namespace



  // "WHAT [COMPONENT] of NAME": names of kinds may contain blanks, so that the last word is a
  // component only if the rest is a kind.
  QuantityName
  read_quantity(const std::string   &text,
                const std::string   &place,
                const QuantityNames &names,
                const int            dim)
  {
    QuantityName result;
    result.text        = text;
    const auto divider = text.find(" of ");
    result.what        = text.substr(0, divider);
    if (divider != std::string::npos)
      result.of = text.substr(divider + 4);

    // If the whole text before " of " is no kind, its last word is taken as the component.
    const Kind *kind = find_kind(result.what);
    if (const auto blank = result.what.rfind(' '); !kind && blank != std::string::npos)
      if (const Kind *other = find_kind(result.what.substr(0, blank)))
        {
          kind             = other;
          result.component = result.what.substr(blank + 1);
          result.what      = result.what.substr(0, blank);
        }
    if (!kind)
      throw SceneError(place + ": there is no quantity '" + text + "'. There are: " + examples() +
                       "; force, friction force, reaction, motion and displacement also by "
                       "components, as 'force y of PAIR', stress as 'stress xy of PROBE'.");
    // A tensor needs a component; other kinds accept one of theirs or none.
    const std::vector<std::string> components = possible_components(*kind, dim);
    const bool                     is_one =
      std::find(components.begin(), components.end(), result.component) != components.end();
    if (!is_one && (!result.component.empty() || kind->components == ComponentKind::tensor))
      throw SceneError(
        place + ": '" + text + "': " + kind->what +
        (components.empty() ? " has no components" : " has the components " + join(components)));

    // The name behind " of " must exist among the items to which the kind refers.
    const std::vector<std::string> &existing =
      kind->of == QuantityTarget::pair     ? names.pairs :
      kind->of == QuantityTarget::support  ? names.supports :
      kind->of == QuantityTarget::obstacle ? names.obstacles :
      kind->of == QuantityTarget::body     ? names.bodies :
      kind->of == QuantityTarget::probe    ? names.probes :
                                             names.surface_probes;
    const std::string what = kind->of == QuantityTarget::pair     ? "contact pair" :
                             kind->of == QuantityTarget::support  ? "support" :
                             kind->of == QuantityTarget::obstacle ? "obstacle that moves freely" :
                             kind->of == QuantityTarget::body     ? "body" :
                             kind->of == QuantityTarget::probe    ? "probe of one point in a body" :
                                                                    "probe of one point on a pair";
    if (kind->of != QuantityTarget::nothing &&
        std::find(existing.begin(), existing.end(), result.of) == existing.end())
      throw SceneError(place + ": '" + text + "': there is no " + what + " '" + result.of + "'" +
                       (existing.empty() ? "." : ". There are: " + join(existing) + "."));
    if (kind->of == QuantityTarget::nothing && !result.of.empty())
      throw SceneError(place + ": '" + text + "': write " + kind->what);
    return result;
  }



  template <>
  Functional
  functional(const QuantityName &name, const Snapshot<2> &snapshot, const Probes<2> &probes)
  {
    return find_kind(name.what)->in_2d(name, snapshot, probes);
  }



  template <>
  Functional
  functional(const QuantityName &name, const Snapshot<3> &snapshot, const Probes<3> &probes)
  {
    return find_kind(name.what)->in_3d(name, snapshot, probes);
  }



  template <int dim>
  Functional
  zero_functional(const Snapshot<dim> &s)
  {
    Functional result;
    result.of_displacement = s.elasticity.zero_vector();
    result.of_traction     = s.contact.zeros();
    return result;
  }



  unsigned int
  component_number(const std::string &component)
  {
    return component == "x" ? 0 : component == "y" ? 1 : 2;
  }



  Functional
  size_or_component(const QuantityName &name, const std::vector<Functional> &components)
  {
    if (!name.component.empty())
      return components[component_number(name.component)];
    double square = 0;
    for (const Functional &one : components)
      square += one.value * one.value;
    Functional result      = components.front();
    result.value           = std::sqrt(square);
    result.unresolved      = 0;
    result.of_displacement = 0;
    if (result.of_volumetric_stress.size() > 0)
      result.of_volumetric_stress = 0;
    for (LA::Vector &component : result.of_traction)
      component = 0;
    if (result.lift.size() > 0)
      result.lift = 0;
    // The norm of a vector that is zero has no derivative: that of the sum of the components is
    // taken.
    for (const Functional &one : components)
      {
        const double share = result.value > 0 ? one.value / result.value : 1;
        result.unresolved += std::abs(share) * one.unresolved;
        result.of_displacement.add(share, one.of_displacement);
        if (one.of_volumetric_stress.size() > 0)
          result.of_volumetric_stress.add(share, one.of_volumetric_stress);
        for (unsigned int a = 0; a < result.of_traction.size(); ++a)
          result.of_traction[a].add(share, one.of_traction[a]);
        if (result.lift.size() > 0)
          result.lift.add(share, one.lift);
      }
    return result;
  }



  template Functional
  zero_functional(const Snapshot<2> &);
  template Functional
  zero_functional(const Snapshot<3> &);
} // namespace Signorini
