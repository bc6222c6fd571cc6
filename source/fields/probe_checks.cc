// SPDX-License-Identifier: Apache-2.0
#include "fields/probe_cells.h"
#include "fields/probes.h"
#include "fields/surface_probes.h"
#include <signorini/parameters/raw.h>

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Throw SceneError for a probe outside of its body. Collective.
    template <int dim>
    void
    check_in_bodies(const Elasticity<dim>         &elasticity,
                    const std::vector<Probe<dim>> &probes,
                    const double                   tolerance)
    {
      const auto claims =
        all_claims(own_locations(elasticity, probes, tolerance), elasticity.mesh().communicator());
      for (unsigned int i = 0; i < probes.size(); ++i)
        if (claims[rank_of_best_claim(claims, i)][i].distance > tolerance)
          throw_outside_of_bodies(probes[i], elasticity.mesh());
    }
  } // namespace



  template <int dim>
  unsigned int
  pair_of(const Probe<dim> &probe, const std::vector<ContactPair<dim>> &pairs)
  {
    std::vector<std::string> names;
    for (const ContactPair<dim> &pair : pairs)
      names.push_back(pair.name);
    const auto found = std::find(names.begin(), names.end(), probe.pair);
    if (found == names.end())
      throw SceneError(probe.title() + "there is no contact pair '" + probe.pair + "'" +
                       (names.empty() ? "" : "; the pairs are " + join(names)));
    return found - names.begin();
  }



  template <int dim>
  void
  check_probes(const Elasticity<dim>               &elasticity,
               const std::vector<ContactPair<dim>> &pairs,
               const std::vector<Probe<dim>>       &probes,
               const double                         tolerance)
  {
    std::vector<Probe<dim>> in_bodies;
    for (const Probe<dim> &probe : probes)
      if (probe.is_on_pair())
        check_on_surface(
          elasticity, pairs[pair_of(probe, pairs)].slave, probe.points(), tolerance, probe.title());
      else
        for (const Probe<dim> &one : probe.single())
          in_bodies.push_back(one);
    check_in_bodies(elasticity, in_bodies, tolerance);
  }



  template unsigned int
  pair_of(const Probe<2> &, const std::vector<ContactPair<2>> &);
  template unsigned int
  pair_of(const Probe<3> &, const std::vector<ContactPair<3>> &);
  template void
  check_probes(const Elasticity<2> &,
               const std::vector<ContactPair<2>> &,
               const std::vector<Probe<2>> &,
               double);
  template void
  check_probes(const Elasticity<3> &,
               const std::vector<ContactPair<3>> &,
               const std::vector<Probe<3>> &,
               double);
} // namespace Signorini
