// SPDX-License-Identifier: Apache-2.0
#include "fields/surface_probes.h"
#include "output/results.h"

#include <array>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// @return the components of a tensor by name.
    Json
    components(const SymmetricTensor<2, 3> &tensor)
    {
      return {{"xx", tensor[0][0]},
              {"yy", tensor[1][1]},
              {"zz", tensor[2][2]},
              {"xy", tensor[0][1]},
              {"yz", tensor[1][2]},
              {"xz", tensor[0][2]}};
    }



    /// @return the entry of a point in a body.
    template <int dim>
    Json
    in_body(const Point<dim> &place, const ProbeValue<dim> &value)
    {
      const std::array<double, 3> principal_stress = eigenvalues(value.stress), // the largest first
        principal_strain                           = eigenvalues(value.strain);
      return {{"place", list<dim>(place)},
              {"displacement", list(value.displacement)},
              {"stress", components(value.stress)},
              {"principal_stress", list(principal_stress)},
              {"von_mises", value.von_mises},
              {"strain", components(value.strain)},
              {"principal_strain", list(principal_strain)}};
    }

    /// @return the entries of all points of a probe on a slave surface. Collective.
    template <int dim>
    Json
    on_pair(const Snapshot<dim> &snapshot, const Probe<dim> &probe)
    {
      Json result = Json::array();
      for (const SurfaceValue<dim> &at : evaluate_on_slave(
             snapshot, pair_of(probe, snapshot.pairs), probe.points(), probe.title()))
        result.push_back({{"place", list<dim>(at.place)},
                          {"displacement", list(at.displacement)},
                          {"pressure", at.pressure},
                          {"gap", std::isfinite(at.gap) ? Json(at.gap) : Json(nullptr)}});
      return result;
    }
  } // namespace



  // Points in bodies are evaluated together, since each evaluation visits all cells.
  template <int dim>
  Json
  probe_results(const Snapshot<dim> &snapshot, const std::vector<Probe<dim>> &probes)
  {
    std::vector<Probe<dim>> in_bodies; // looked for together
    for (const Probe<dim> &probe : probes)
      for (const Probe<dim> &one : probe.single())
        if (!probe.is_on_pair())
          in_bodies.push_back(one);
    const auto values = evaluate_probes(snapshot.elasticity, snapshot.displacement, in_bodies);

    Json result = Json::object();
    auto value  = values.begin();
    for (const Probe<dim> &probe : probes)
      {
        Json along = probe.is_on_pair() ? on_pair(snapshot, probe) : Json::array();
        if (!probe.is_on_pair())
          for (const Point<dim> &place : probe.points())
            along.push_back(in_body(place, *value++));
        result[probe.name] = probe.is_line() ? along : along.front();
      }
    return result;
  }



  template Json
  probe_results(const Snapshot<2> &, const std::vector<Probe<2>> &);
  template Json
  probe_results(const Snapshot<3> &, const std::vector<Probe<3>> &);
} // namespace Signorini
