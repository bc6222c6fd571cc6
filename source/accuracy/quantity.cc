#include "accuracy/quantities/kinds.h"
#include <signorini/base/text.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  namespace
  {
    /// What a quantity may be of.
    enum class Of
    {
      pair,
      support,
      obstacle,
      probe,         ///< a point in a body
      surface_probe, ///< a point on a pair
      nothing
    };

    enum class ComponentsOf
    {
      none,
      vector, ///< one of x, y, z, or none
      tensor  ///< one of xx, yy, zz, xy, ...
    };

    struct Kind
    {
      const char  *what;
      Of           of;
      ComponentsOf components;
      Functional (*in_2d)(const QuantityName &, const Snapshot<2> &, const Probes<2> &);
      Functional (*in_3d)(const QuantityName &, const Snapshot<3> &, const Probes<3> &);
    };

    const std::vector<Kind> &
    kinds()
    {
      static const std::vector<Kind> all = {
        {"force", Of::pair, ComponentsOf::vector, pair_force<2>, pair_force<3>},
        {"normal force", Of::pair, ComponentsOf::none, normal_force<2>, normal_force<3>},
        {"mean pressure", Of::pair, ComponentsOf::none, mean_pressure<2>, mean_pressure<3>},
        {"largest pressure",
         Of::pair,
         ComponentsOf::none,
         largest_pressure<2>,
         largest_pressure<3>},
        {"contact area", Of::pair, ComponentsOf::none, contact_area<2>, contact_area<3>},
        {"half-width", Of::pair, ComponentsOf::none, half_width<2>, half_width<3>},
        {"contact radius", Of::pair, ComponentsOf::none, contact_radius<2>, contact_radius<3>},
        {"reaction", Of::support, ComponentsOf::vector, reaction<2>, reaction<3>},
        {"motion", Of::obstacle, ComponentsOf::vector, motion<2>, motion<3>},
        {"displacement",
         Of::probe,
         ComponentsOf::vector,
         probe_displacement<2>,
         probe_displacement<3>},
        {"stress", Of::probe, ComponentsOf::tensor, probe_stress<2>, probe_stress<3>},
        {"von Mises", Of::probe, ComponentsOf::none, probe_von_mises<2>, probe_von_mises<3>},
        {"pressure", Of::surface_probe, ComponentsOf::none, probe_pressure<2>, probe_pressure<3>},
        {"energy", Of::nothing, ComponentsOf::none, energy<2>, energy<3>}};
      return all;
    }

    const Kind *
    find_kind(const std::string &what)
    {
      const auto found = std::find_if(kinds().begin(), kinds().end(), [&](const Kind &kind) {
        return kind.what == what;
      });
      return found == kinds().end() ? nullptr : &*found;
    }

    std::vector<std::string>
    possible_components(const Kind &kind, const int dim)
    {
      if (kind.components == ComponentsOf::none)
        return {};
      if (kind.components == ComponentsOf::tensor)
        return {"xx", "yy", "zz", "xy", "yz", "xz"};
      return dim == 2 ? std::vector<std::string>{"x", "y"} :
                        std::vector<std::string>{"x", "y", "z"};
    }

    std::string
    examples()
    {
      std::vector<std::string> all;
      for (const Kind &kind : kinds())
        all.push_back(std::string(kind.what) + (kind.of == Of::pair     ? " of PAIR" :
                                                kind.of == Of::support  ? " of SUPPORT" :
                                                kind.of == Of::obstacle ? " of OBSTACLE" :
                                                kind.of == Of::probe    ? " of PROBE" :
                                                kind.of == Of::surface_probe ?
                                                                       " of PROBE (on a pair)" :
                                                                       ""));
      return join(all);
    }
  } // namespace



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
                       "; force, reaction, motion and displacement also by components, as 'force y "
                       "of PAIR', stress as 'stress xy of PROBE'.");
    const std::vector<std::string> components = possible_components(*kind, dim);
    const bool                     is_one =
      std::find(components.begin(), components.end(), result.component) != components.end();
    if (!is_one && (!result.component.empty() || kind->components == ComponentsOf::tensor))
      throw SceneError(
        place + ": '" + text + "': " + kind->what +
        (components.empty() ? " has no components" : " has the components " + join(components)));

    const std::vector<std::string> &existing = kind->of == Of::pair     ? names.pairs :
                                               kind->of == Of::support  ? names.supports :
                                               kind->of == Of::obstacle ? names.obstacles :
                                               kind->of == Of::probe    ? names.probes :
                                                                          names.surface_probes;
    const std::string               what     = kind->of == Of::pair    ? "contact pair" :
                                               kind->of == Of::support ? "support" :
                                               kind->of == Of::obstacle ? "obstacle that moves freely" :
                                               kind->of == Of::probe ? "probe of one point in a body" :
                                                                       "probe of one point on a pair";
    if (kind->of != Of::nothing &&
        std::find(existing.begin(), existing.end(), result.of) == existing.end())
      throw SceneError(place + ": '" + text + "': there is no " + what + " '" + result.of + "'" +
                       (existing.empty() ? "." : ". There are: " + join(existing) + "."));
    if (kind->of == Of::nothing && !result.of.empty())
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
    result.of_pressure     = s.contact.zero();
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
    result.of_displacement = 0;
    result.of_pressure     = 0;
    if (result.lift.size() > 0)
      result.lift = 0;
    // Without a direction there is no derivative: let it be that of the sum.
    for (const Functional &one : components)
      {
        const double share = result.value > 0 ? one.value / result.value : 1;
        result.of_displacement.add(share, one.of_displacement);
        result.of_pressure.add(share, one.of_pressure);
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
