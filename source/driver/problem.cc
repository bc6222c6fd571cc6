// SPDX-License-Identifier: Apache-2.0
#include "driver/problem.h"

#include "accuracy/p_refinement.h"
#include "accuracy/refinement.h"
#include "driver/scene_setup.h"
#include "solid/deformation_change.h"
#include <signorini/base/text.h>
#include <signorini/parameters/raw.h>

#include <algorithm>
#include <utility>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  Problem<dim>::Problem(const Scene<dim>            &scene,
                        const MPI_Comm               comm,
                        ConditionalOStream          &out,
                        TimerOutput                 &timer,
                        std::function<StepVisitor()> watch)
    : decisions(scene)
    , scene(scene)
    , comm(comm)
    , out(out)
    , timer(timer)
    , watch(std::move(watch))
  {}



  template <int dim>
  void
  Problem<dim>::make_mesh()
  {
    mesh = Signorini::make_mesh(decisions, comm);
    if (!decisions.pairs_are_open)
      return;
    decisions.pairs          = automatic_pairs(scene, *mesh, out);
    decisions.pairs_are_open = false;
    decisions.check();
    // The mesh is made again: contact surfaces are refined, and weigh more in its distribution.
    mesh = Signorini::make_mesh(decisions, comm);
  }



  template <int dim>
  void
  Problem<dim>::set_up()
  {
    elasticity = make_elasticity(decisions, *mesh);
    elasticity->setup();
    state.displacement = elasticity->zero_vector();
    set_up_contact();
  }



  template <int dim>
  void
  Problem<dim>::set_up_contact()
  {
    contact     = std::make_unique<ContactInterfaces<dim>>(decisions, *elasticity, timer, out);
    equilibrium = std::make_unique<Equilibrium<dim>>(
      decisions, *elasticity, *contact, state, timer, out, watch);
  }



  // With Deformation = automatic the load step is solved at small strain first; if the neglected
  // work is too large, it is solved again at finite strain from the state before it, and all later
  // steps are (doc/theory, 6.7).
  template <int dim>
  bool
  Problem<dim>::solve(const double t, const double tolerance)
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
  Problem<dim>::change_supports(const double t)
  {
    out << "  supports: a change of what is prescribed" << std::endl;
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
  // tolerance or a share of the smallest target error.
  template <int dim>
  bool
  Problem<dim>::is_small_enough()
  {
    TimerOutput::Scope scope(timer, "deformation");
    double             limit = scene.deformation_share;
    // It is a part of the error bounds, which leaves room for the others.
    for (const double target : scene.goals.targets)
      limit = std::min(limit, 0.3 * target);
    Decisions<dim> at_finite_strain = decisions;
    at_finite_strain.finite_strain  = true;
    std::vector<std::shared_ptr<const ConstitutiveLaw>> laws;
    for (unsigned int body = 0; body < scene.bodies.size(); ++body)
      for (const Material &material : at_finite_strain.materials(body))
        laws.push_back(material.constitutive_law);
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
  Problem<dim>::switch_to_finite_strain(const State &before)
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
    nlohmann::ordered_json known = contact->save();
    // Search tolerances are estimated anew, since motions may be much larger.
    for (nlohmann::ordered_json &pair : known)
      for (const char *key : {"reach", "nearby", "known"})
        pair.erase(key);
    replace_elasticity(std::move(finite), before, true, known);
  }



  // The order matters: equilibrium and contact refer to the elasticity. Contact is first searched
  // in the reference configuration, where initial overlaps are found.
  template <int dim>
  void
  Problem<dim>::replace_elasticity(std::unique_ptr<Elasticity<dim>> other,
                                   const State                     &carried,
                                   const bool                       uses_current_geometry,
                                   const nlohmann::ordered_json    &known)
  {
    equilibrium.reset();
    contact.reset();
    elasticity = std::move(other);
    set_up_contact();
    contact->load(known);
    equilibrium->find_contact();
    equilibrium->set_state(carried, uses_current_geometry);
  }



  template <int dim>
  void
  Problem<dim>::leave_mesh()
  {
    former_cycles  = 0;
    former_seconds = 0;
    equilibrium->configuration_solver.release();
  }



  template <int dim>
  void
  Problem<dim>::refine_mesh()
  {
    leave_mesh();
    std::vector<LA::Vector *> displacements = {&state.displacement};
    if (state.start.displacement.size() > 0)
      displacements.push_back(&state.start.displacement);
    refine(*mesh, *elasticity, displacements);
    equilibrium->invalidate();
  }



  // Raise the degree of bodies to 2 on the same mesh; displacements are interpolated, the
  // volumetric stress starts from zero. Collective.
  template <int dim>
  void
  Problem<dim>::p_refine(const std::vector<unsigned int> &bodies)
  {
    leave_mesh();
    for (const unsigned int body : bodies)
      decisions.raise_degree(body);
    mesh->set_degrees(decisions.degrees);
    auto richer = make_elasticity(decisions, *mesh);
    richer->setup(elasticity->time_of_supports());
    State carried             = state;
    carried.volumetric_stress = LA::Vector();
    carried.displacement      = p_refined(*elasticity, state.displacement, *richer);
    if (state.start.displacement.size() > 0)
      carried.start.displacement = p_refined(*elasticity, state.start.displacement, *richer);
    replace_elasticity(std::move(richer),
                       carried,
                       equilibrium->uses_current_geometry(),
                       contact->save());
  }



  template <int dim>
  unsigned int
  Problem<dim>::multigrid_cycles() const
  {
    return former_cycles + equilibrium->configuration_solver.multigrid_cycles();
  }



  template <int dim>
  double
  Problem<dim>::mesh_seconds() const
  {
    return former_seconds + Utilities::MPI::max(equilibrium->configuration_solver.seconds(), comm);
  }



  template class Problem<2>;
  template class Problem<3>;
} // namespace Signorini
