// SPDX-License-Identifier: Apache-2.0
#include "driver/adaptive_refinement.h"

#include "accuracy/p_refinement.h"
#include "output/accuracy_results.h"
#include "output/memory.h"
#include <signorini/base/text.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>
#include <tuple>
#include <utility>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// @return the memory that ranks have in use [MB]. Collective.
    double
    memory_in_use(const MPI_Comm ranks)
    {
      Utilities::System::MemoryStats stats;
      Utilities::System::get_memory_stats(stats);
      return Utilities::MPI::sum(stats.VmRSS / 1024., ranks);
    }

    /// True on all ranks if a mesh that is larger by a factor fits into memory: the additional
    /// memory of the ranks on each machine, in proportion to the present use, is at most nine
    /// tenths of what is available there. Collective.
    bool
    has_memory_for(const double growth, const MPI_Comm comm)
    {
      constexpr double usable = 0.9;
      MPI_Comm         node;
      MPI_Comm_split_type(comm, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &node);
      const double used = 1024 * memory_in_use(node); // kB
      MPI_Comm_free(&node);
      const double more = (growth - 1) * used; // kB
      const bool   fits = more <= usable * available_memory();
      return Utilities::MPI::min(int(fits), comm) == 1;
    }

    /// Remove all coarsening flags.
    template <int dim>
    void
    forbid_coarsening(const Mesh<dim> &mesh)
    {
      for (const auto &cell : mesh.triangulation().active_cell_iterators())
        cell->clear_coarsen_flag();
    }

    /// The names of bodies, for messages.
    template <int dim>
    std::string
    names_of(const std::vector<unsigned int> &numbers, const std::vector<Body<dim>> &bodies)
    {
      std::vector<std::string> names;
      for (const unsigned int body : numbers)
        names.push_back(bodies[body].name);
      return join(names);
    }
  } // namespace



  template <int dim>
  AdaptiveRefinement<dim>::AdaptiveRefinement(const Scene<dim>   &scene,
                                              Problem<dim>       &problem,
                                              const MPI_Comm      comm,
                                              ConditionalOStream &out,
                                              TimerOutput        &timer,
                                              const Timer        &clock)
    : control(scene.goals, scene.refinement)
    , tolerance(std::max(scene.newton.tolerance, scene.refinement.tolerance))
    , scene(scene)
    , problem(problem)
    , comm(comm)
    , out(out)
    , timer(timer)
    , clock(clock)
    , memory_at_start(memory_in_use(comm))
  {}



  // One cycle of the adaptive solution: estimate the errors, decide which part dominates (mesh,
  // penalty, tolerance), and change that: refine or raise degrees, scale the penalty, tighten the
  // tolerance. Returns false if the targets are met or cannot be met. Collective.
  template <int dim>
  bool
  AdaptiveRefinement<dim>::improve(ErrorControl      &control,
                                   const unsigned int cycle,
                                   Recorder<dim>     &recorder)
  {
    const bool          is_end   = &control == &this->control;
    const ErrorEstimate estimate = is_end && of_end ? std::move(*of_end) : judge(control, cycle);
    of_end.reset();
    Json accuracy = accuracy_results(scene.goals, control, estimate);
    if (!is_end)
      step_accuracy = accuracy;
    const ErrorControl  *refined_for = &control;
    const ErrorEstimate *chosen      = &estimate;
    if (scene.goals.has_targets())
      {
        tolerance                     = control.tolerance(tolerance);
        const bool path_is_final      = !is_end || is_resolved(cycle);
        reason_targets_missed         = control.obstacle(path_is_final);
        std::tie(refined_for, chosen) = worst_load_step(control, estimate, path_is_final);
        if (!refined_for)
          return false;
        const double stiffening = refined_for->stiffening();
        problem.decisions.penalty_factor *= stiffening;
        accuracy["stiffening"] = stiffening;
        if (stiffening > 1)
          out << "  penalties times " << short_text(stiffening) << std::endl;
      }
    TimerOutput::Scope scope(timer, "refinement");
    if (!mark(*refined_for, *chosen))
      return false;
    if (!is_end)
      accuracy["time"] = problem.state.time;
    if (!next_mesh.is_null())
      accuracy["next"] = std::exchange(next_mesh, {});
    recorder.add_cycle(n_steps, problem.multigrid_cycles(), accuracy);
    if (next_quadratic.empty())
      problem.refine_mesh();
    else
      problem.p_refine(std::exchange(next_quadratic, {}));
    if (is_end)
      end_judged_on.reset();
    worst = {};
    return true;
  }



  // Mark cells (or bodies for degree 2) for the next mesh, and predict its size, time and memory.
  // Returns false, and clears the marks, if a limit would be exceeded. Collective.
  template <int dim>
  bool
  AdaptiveRefinement<dim>::mark(const ErrorControl &control, const ErrorEstimate &estimate)
  {
    const std::vector<double> indicators = control.indicators(estimate.cells, comm);
    // Without targets the settings determine which share of the cells is refined.
    if (!scene.goals.has_targets())
      {
        mark_cells(scene.refinement, *problem.mesh, indicators);
        return true;
      }
    // If the error of the mesh dominates: a higher degree where this is more efficient, else cells
    // with the largest indicators.
    if (control.needs_mesh())
      {
        next_quadratic = bodies_to_p_refine(*problem.mesh,
                                            indicators,
                                            problem.decisions.open_degrees,
                                            control.excess_error());
        if (next_quadratic.empty())
          mark_share(scene.refinement, *problem.mesh, indicators, control.share());
      }
    // Meshes of single load steps are only refined, since other load steps need their fine cells.
    if (&control != &this->control)
      forbid_coarsening(*problem.mesh);
    const double of_cells = growth(*problem.mesh),
                 factor   = of_cells * growth_of_p_refinement(*problem.mesh, next_quadratic),
                 cells    = of_cells * problem.mesh->triangulation().n_global_active_cells(),
                 dofs     = factor * problem.elasticity->dof_handler().n_dofs(),
                 seconds = seconds_of_next(dofs), limit = 60 * scene.goals.time_limit;
    if (cells > scene.refinement.maximum_cells)
      reason_targets_missed =
        "Accuracy/Maximum cells = " + std::to_string(scene.refinement.maximum_cells);
    // With a reserve of 0.3. Histories that depend on their path are solved once more in the end.
    else if (const double all = (problem.equilibrium->is_path_dependent() ? 2.6 : 1.3) * seconds;
             limit > 0 && Utilities::MPI::max(last_mesh.at + all, comm) > limit)
      reason_targets_missed = "the next mesh would end after Accuracy/Time limit = " +
                              short_text(scene.goals.time_limit, 3) + " minutes";
    else if (!has_memory_for(factor, comm))
      reason_targets_missed = "the next mesh would not fit into memory";
    if (!reason_targets_missed.empty())
      {
        clear_marks(*problem.mesh);
        return false;
      }
    const double memory = memory_at_start + factor * (memory_in_use(comm) - memory_at_start);
    next_mesh           = {{"dofs", dofs}, {"seconds", seconds}, {"memory_mb", memory}};
    out << "  next: ";
    if (next_quadratic.empty())
      out << "about " << static_cast<unsigned int>(cells) << " cells, errors of the mesh times "
          << short_text(control.expected_reduction());
    else
      out << "degree 2 for " << names_of(next_quadratic, scene.bodies);
    out << ", " << short_text(seconds, 2) << " s, " << short_text(memory, 2) << " MB" << std::endl;
    return true;
  }



  // A part of the seconds does not grow with the mesh: the growth is that between the last two
  // meshes, but at most in proportion to the size, and at least by a third of that.
  template <int dim>
  double
  AdaptiveRefinement<dim>::seconds_of_next(const double dofs)
  {
    constexpr double least = 1. / 3;
    const double     now = clock.wall_time(), size = problem.elasticity->dof_handler().n_dofs(),
                 seconds = now - last_mesh.at, proportional = seconds / size;
    double rate = proportional;
    if (last_mesh.dofs > 0 && size > last_mesh.dofs)
      rate = std::clamp((seconds - last_mesh.seconds) / (size - last_mesh.dofs),
                        least * proportional,
                        proportional);
    last_mesh = {now, seconds, size};
    return std::max(seconds + rate * (dofs - size), least * seconds);
  }



  // Add the estimate on this mesh to the history of the quantities. A second estimate for the end
  // on the same mesh replaces the first, since error histories compare different meshes.
  template <int dim>
  ErrorEstimate
  AdaptiveRefinement<dim>::judge(ErrorControl &control, const unsigned int cycle)
  {
    const ErrorEstimate estimate = estimate_errors();
    const bool          is_end   = &control == &this->control;
    if (is_end && end_judged_on && problem.equilibrium->is_path_dependent())
      control.follow_path(estimate.quantities);
    else if (is_end && end_judged_on)
      control.replace_last(estimate.quantities);
    else
      control.add(estimate.quantities);
    if (is_end)
      {
        end_judged_on = cycle;
        if (!steps_of_path.empty() && problem.equilibrium->is_path_dependent())
          control.set_least(least_on_path());
      }
    report_errors(control);
    return estimate;
  }



  template <int dim>
  std::string
  AdaptiveRefinement<dim>::missed_targets(const ErrorControl &control) const
  {
    if (!scene.goals.has_targets() || control.is_met())
      return {};
    if (!reason_targets_missed.empty())
      return reason_targets_missed;
    return control.is_met(true) ?
             "the algebraic error cannot be reduced further (a quantity that is zero but for rounding "
             "has no relative error: choose another one, or another component)" :
             "Accuracy/Refinement cycles = " + std::to_string(scene.maximum_cycles());
  }



  template <int dim>
  void
  AdaptiveRefinement<dim>::report_errors(const ErrorControl &control)
  {
    if (control.quantities().empty())
      return;
    std::ostringstream text;
    print_accuracy(scene.goals, control, text);
    out << text.str() << std::flush;
  }



  template <int dim>
  void
  AdaptiveRefinement<dim>::estimate_result(const unsigned int cycle, Recorder<dim> &recorder)
  {
    const ErrorEstimate estimate = judge(control, cycle);
    recorder.add_accuracy(accuracy_results(scene.goals, control, estimate),
                          control,
                          missed_targets(control),
                          lacks_former_steps());
  }



  // One dual problem for each quantity with the linearisation at the solution (doc/theory, chapter
  // 8), then the parts of the error. At small sliding the neglected geometry is one of them.
  template <int dim>
  ErrorEstimate
  AdaptiveRefinement<dim>::estimate_errors()
  {
    const bool                is_unstable = problem.report().tangent_is_indefinite;
    const Snapshot<dim>       now         = problem.equilibrium->snapshot(0);
    std::vector<Functional>   functionals;
    std::vector<DualSolution> duals;
    for (const QuantityName &name : problem.decisions.quantities())
      {
        functionals.push_back(functional(name, now, scene.output.probes));
        if (!is_unstable)
          duals.push_back(problem.equilibrium->configuration_solver.dual(functionals.back()));
      }
    TimerOutput::Scope  scope(timer, "estimate");
    const PressureShift pressure_shift = scene.contact.chosen().pressure_shift();
    const bool          is_consistent =
      pressure_shift == PressureShift::multiplier || pressure_shift == PressureShift::normal_stress;
    // What the model leaves out: the current geometry of contact, and with Deformation = automatic
    // the finite strain that was found to be negligible.
    double neglected = 0;
    if (!problem.equilibrium->uses_current_geometry())
      neglected += problem.equilibrium->neglected().value_or(0.);
    if (!problem.elasticity->is_finite_strain())
      neglected += problem.neglected_work.value_or(0.);
    ErrorEstimate result = error_estimate(
      now, functionals, duals, is_consistent, errors_of_path(problem.state.time), neglected);
    if (problem.equilibrium->is_path_dependent() && !is_unstable)
      add_former_errors(result);
    // Beyond a buckling load the linear solver would not converge, and what it returned would be no
    // sensitivity of this solution.
    if (is_unstable)
      for (const Functional &one : functionals)
        {
          QuantityEstimate unknown;
          unknown.value       = one.value;
          unknown.is_unstable = true;
          result.quantities.push_back(unknown);
          result.cells.products.emplace_back(result.cells.energy.size(), 0.);
        }
    return result;
  }



  template class AdaptiveRefinement<2>;
  template class AdaptiveRefinement<3>;
} // namespace Signorini
