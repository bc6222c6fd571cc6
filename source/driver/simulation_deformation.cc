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



  template <int dim>
  void
  Simulation<dim>::switch_to_finite_strain(const State &before)
  {
    decisions.finite_strain = true;
    try
      {
        decisions.check(); // what goes with small deformation alone
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
    for (Json &pair : known) // how far to look is another matter there
      for (const char *key : {"reach", "nearby", "known"})
        pair.erase(key);
    replace_elasticity(std::move(finite), before, true, known);
  }



  template <int dim>
  void
  Simulation<dim>::replace_elasticity(std::unique_ptr<Elasticity<dim>> other,
                                      const State                     &carried,
                                      const bool                       uses_current_geometry,
                                      const Json                      &known)
  {
    equilibrium.reset(); // these refer to it
    contact.reset();
    elasticity = std::move(other);
    set_up_contact();
    contact->load(known);
    equilibrium->find_contact(); // as it is at rest, where initial overlaps are
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
