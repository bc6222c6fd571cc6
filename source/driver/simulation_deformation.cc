// SPDX-License-Identifier: Apache-2.0
#include "driver/body_setup.h"
#include "driver/simulation.h"
#include "materials/material_law.h"
#include "solid/deformation_change.h"
#include <signorini/base/text.h>
#include <signorini/parameters/raw.h>

#include <algorithm>
#include <utility>

namespace Signorini
{
  using namespace dealii;

  // With Deformation = automatic the load step is solved at small strain first; if the neglected
  // work is too large, it is solved again at finite strain from the state before it, and all later
  // steps are (doc/theory, 6.7).
  template <int dim>
  bool
  Simulation<dim>::solve(const double t, const double tolerance)
  {
    if (!elasticity->has_supports_of(t))
      change_supports(t);
    if (scene.deformation != Deformation::automatic || decisions.finite_strain)
      return equilibrium->solve(t, tolerance);
    const State before = state;
    if (!equilibrium->solve(t, tolerance))
      return false;
    if (is_small_enough())
      return true;
    switch_to_finite_strain(before);
    return equilibrium->solve(t, tolerance);
  }



  // Other supports have other constraints: elasticity and contact are made again on the same mesh
  // and continue from the same state. Costs so far are carried over.
  template <int dim>
  void
  Simulation<dim>::change_supports(const double t)
  {
    out << "  supports: a change of the active supports" << std::endl;
    former_cycles  = multigrid_cycles();
    former_seconds = mesh_seconds();
    auto other     = make_elasticity(decisions, *mesh);
    other->setup(t);
    const State carried = state;
    replace_elasticity(std::move(other),
                       carried,
                       equilibrium->uses_current_geometry(),
                       contact->save());
    equilibrium->configuration_solver.restore_active_set();
  }



  // Estimate (6.21) with the hyperelastic laws that finite strain would use; the limit is the
  // tolerance or the smallest target error.
  template <int dim>
  bool
  Simulation<dim>::is_small_enough()
  {
    TimerOutput::Scope scope(timer, "deformation");
    double             limit = scene.deformation_share;
    for (const double target : scene.goals.targets)
      limit = std::min(limit, target);
    std::vector<std::shared_ptr<const ConstitutiveLaw>> laws;
    for (unsigned int body = 0; body < scene.bodies.size(); ++body)
      for (const Material &material : decisions.materials(body))
        laws.push_back(law_of(material).make(material));
    const DeformationChange change   = deformation_change(*elasticity, laws, state.displacement);
    const bool              is_small = change.work <= limit;
    neglected_work                   = std::max(neglected_work.value_or(0), change.work);
    out << "  deformation: the relative work error of small strain is about "
        << short_text(100 * change.work, 2) << " % (strains up to "
        << short_text(100 * change.strain, 2) << " %, rotations up to "
        << short_text(change.largest_rotation * 180 / numbers::PI, 2) << " degrees)"
        << (is_small ? "" : ": finite strain from here on") << std::endl;
    return is_small;
  }



  // Make finite-strain elasticity on the same mesh and restore the state before the load step.
  // Throws SceneError if the scene uses features that require small strain.
  template <int dim>
  void
  Simulation<dim>::switch_to_finite_strain(const State &before)
  {
    decisions.finite_strain = true;
    try
      {
        // Features that are available at small strain only are rejected here.
        decisions.check();
      }
    catch (const SceneError &error)
      {
        throw SceneError(
          std::string(error.what()) +
          ". Deformation = automatic changed to finite, because the relative work error of small strain is " +
          short_text(100 * *neglected_work, 2) +
          " %; set Deformation = small, or a larger Finite-strain tolerance");
      }
    auto finite = make_elasticity(decisions, *mesh);
    finite->setup(elasticity->time_of_supports());
    Json known = contact->save();
    // Search tolerances are estimated anew, since motions may be much larger.
    for (Json &pair : known)
      for (const char *key : {"reach", "nearby", "known"})
        pair.erase(key);
    replace_elasticity(std::move(finite), before, true, known);
  }



  // The order matters: equilibrium and contact refer to the elasticity. Contact is first searched
  // in the reference configuration, where initial overlaps are found.
  template <int dim>
  void
  Simulation<dim>::replace_elasticity(std::unique_ptr<Elasticity<dim>> other,
                                      const State                     &carried,
                                      const bool                       uses_current_geometry,
                                      const Json                      &known)
  {
    equilibrium.reset();
    contact.reset();
    elasticity = std::move(other);
    set_up_contact();
    contact->load(known);
    equilibrium->find_contact();
    equilibrium->set_state(carried, uses_current_geometry);
  }



#define INSTANTIATE(dim)                                                                           \
  template bool Simulation<dim>::solve(double, double);                                            \
  template void Simulation<dim>::change_supports(double);                                          \
  template bool Simulation<dim>::is_small_enough();                                                \
  template void Simulation<dim>::switch_to_finite_strain(const State &);                           \
  template void Simulation<dim>::replace_elasticity(std::unique_ptr<Elasticity<dim>>,              \
                                                    const State &,                                 \
                                                    bool,                                          \
                                                    const Json &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
