// SPDX-License-Identifier: Apache-2.0
// What the user wants to know must exist, which is checked before anything is solved.
#include "driver/simulation.h"
#include "fields/cross_sections.h"
#include "solid/fluid_spread.h"
#include "solid/surface_loads.h"
#include <signorini/base/scene_error.h>

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Throws SceneError where a fluid would act on one of two surfaces alone, or push a rigid body
    /// that a force drives, on which no pressure acts. Collective.
    template <int dim>
    void
    check_fluids(const Decisions<dim> &decisions, const Elasticity<dim> &elasticity)
    {
      check_fluid_entries(elasticity);
      const Mesh<dim> &mesh = elasticity.mesh();
      for (const Load<dim> &load : elasticity.loads())
        for (const ContactPair<dim> &pair : decisions.pairs)
          {
            if (load.fluid_entries.empty())
              continue;
            const BoundaryIds wet     = boundaries_of(mesh, load);
            const auto        acts_on = [&](const std::string &boundary) {
              const BoundaryIds &ids = mesh.boundary_ids(boundary);
              return std::any_of(ids.begin(), ids.end(), [&](const auto id) {
                return wet.count(id) > 0;
              });
            };
            const std::string beginning = "Loads/" + load.name +
                                          "/Fluid entry: the fluid between the surfaces of pair " +
                                          pair.name + " ";
            const Obstacle<dim> *obstacle = decisions.scene.obstacle_of(pair);
            for (unsigned int i = 0; i < RigidBody<dim>::n_dofs; ++i)
              if (obstacle && obstacle->body.is_free(i) && acts_on(pair.slave))
                throw SceneError(
                  beginning + "would push on the obstacle '" + pair.master +
                  "', which a force drives; prescribe its motion, or make it a body");
            if (!obstacle && acts_on(pair.slave) != acts_on(pair.master))
              throw SceneError(beginning + "acts on both; add " +
                               (acts_on(pair.slave) ? pair.master : pair.slave) +
                               " to the Boundaries of the load");
          }
    }
  } // namespace



  // Probes must be inside of bodies, planes must cut them, and expected results must name entries
  // that results will have, which is found by evaluating the outputs of the undeformed state.
  template <int dim>
  void
  Simulation<dim>::check_requests()
  {
    // On a mesh that is still to be refined, curved surfaces are not yet at their final positions.
    const bool is_final = scene.maximum_cycles() == 0;
    check_probes(*problem.elasticity,
                 problem.decisions.pairs,
                 scene.output.probes,
                 is_final ? probe_tolerance : 0.5);
    check_fluids(problem.decisions, *problem.elasticity);
    check_cross_sections(*problem.elasticity, scene.output.cross_sections);
    if (scene.expected.empty())
      return;
    const ContactState  nothing = open_contact(problem.contact->gap_operator());
    const LA::Vector    gap     = problem.contact->gap_operator().gap(problem.state.displacement);
    const Snapshot<dim> start{*problem.elasticity,
                              problem.decisions.pairs,
                              problem.contact->surfaces(),
                              problem.contact->gap_operator(),
                              problem.state.displacement,
                              gap,
                              nothing.pressure(),
                              nothing.status,
                              nothing,
                              problem.state.friction_work,
                              problem.state.start.friction_bound,
                              scene.load_steps.ends().front(),
                              0};
    Json                step =
      results_at(scene, start, is_final ? scene.output.probes : std::vector<Probe<dim>>());
    for (const char *number :
         {"time", "newton_iterations", "active_points", "residual", "multigrid_cycles"})
      step[number] = 0;
    std::vector<std::string> whole{"ranks",
                                   "dimension",
                                   "cycles",
                                   "load_steps",
                                   "cells",
                                   "dofs",
                                   "degrees",
                                   "multiplier_dofs",
                                   "contact_faces",
                                   "contact_candidates",
                                   "contact_bytes",
                                   "seconds",
                                   "partition",
                                   "peak_memory_mb",
                                   "preflight",
                                   "linear_reference",
                                   "contact_geometry",
                                   "deformation"};
    if (!is_final)
      whole.push_back("probes");
    check_paths(scene.expected, step, whole);
  }



  template void
  Simulation<2>::check_requests();
  template void
  Simulation<3>::check_requests();
} // namespace Signorini
