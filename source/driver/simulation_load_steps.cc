// SPDX-License-Identifier: Apache-2.0
// The load history of a run: estimates on coarse meshes, and load steps on the last one.
#include "driver/simulation.h"
#include "output/accuracy_results.h"
#include <signorini/base/text.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace Signorini
{
  using namespace dealii;

  // The end of the load history in one step, which mostly converges; otherwise, and with friction,
  // in steps from the undeformed state. Collective.
  template <int dim>
  bool
  Simulation<dim>::solve_for_estimate()
  {
    if (problem.equilibrium->is_path_dependent())
      return solve_path_for_estimate();
    // Only the end counts, and mostly it is found at once.
    const double end = scene.load_steps.end_time;
    if (problem.solve(end, refinement.tolerance))
      {
        refinement.n_steps = problem.report().steps.size();
        return true;
      }
    if (problem.report().has_unconstrained_modes || scene.load_steps.shortest(end) == end)
      return false;
    out << "  no convergence in one load step (" << problem.report().reason
        << "): applying the load in steps" << std::endl;
    Position start;
    start.longest      = end / 2;
    refinement.n_steps = 0;
    return_to_start();
    return apply_load_history(refinement.tolerance, start, [&](auto) {
      refinement.n_steps += problem.report().steps.size();
      return true;
    });
  }



  template <int dim>
  void
  Simulation<dim>::return_to_start()
  {
    State nothing;
    nothing.displacement = problem.elasticity->zero_vector();
    nothing.contact      = SurfaceField(dim);
    problem.equilibrium->set_state(nothing, problem.equilibrium->uses_current_geometry());
    problem.equilibrium->configuration_solver.restore_active_set();
  }



  // All load steps on the final mesh, each of which may refine it further if all steps are to meet
  // the targets.
  template <int dim>
  void
  Simulation<dim>::run_load_history()
  {
    // A single load step is the solution that was estimated, but other quantities than those of the
    // targets are read from it, too; of several load steps, some may have almost no forces, to
    // which the tolerance is relative. Hence the upper bound. The tolerance for which a target was
    // met by a little may not suffice on another path to the solution: hence a tenth of it.
    constexpr double largest_tolerance = 1e-5, margin = 0.1;
    const bool       is_one = scene.load_steps.ends().size() == 1;
    if (needs_path_errors(true))
      measure_path_errors(true);
    // The meshes before were made for the end of the history, whose state no path has led to.
    if (position.step == 0 && problem.equilibrium->is_path_dependent() && problem.state.time > 0)
      return_to_start();
    const double final_tolerance =
      scene.goals.has_targets() && is_one ?
        std::max(std::min(margin * refinement.tolerance, largest_tolerance),
                 scene.newton.tolerance) :
        scene.newton.tolerance;
    apply_load_history(final_tolerance, position, [&](const unsigned int step) {
      // Meshes that were made for other load steps may be too coarse for the last one by a little.
      const bool is_judged =
        is_finished() && (!refinement.end_judged_on || *refinement.end_judged_on == position.cycle);
      if (scene.goals.judge_all_steps() && !is_judged && !judge_step())
        return false;
      record_step(step);
      pass_checkpoint();
      return true;
    });
  }



  template <int dim>
  bool
  Simulation<dim>::improve(ErrorControl &control)
  {
    if (!refinement.improve(control, position.cycle, *recorder))
      return false;
    // The state of the last checkpoint belongs to the old mesh.
    checkpoints->forget();
    return true;
  }



  // With targets the mesh is refined for the load step, unless the path decides: then a load step
  // is not repeated on another mesh.
  template <int dim>
  bool
  Simulation<dim>::judge_step()
  {
    // Load steps that were shortened to be solved at all are on the way to those of the scene.
    const std::vector<double> ends = scene.load_steps.ends();
    const bool                has_targets =
      scene.goals.has_targets() && (scene.load_steps.is_automatic ||
                                    std::any_of(ends.begin(), ends.end(), [&](const double end) {
                                      return std::abs(end - position.time) <= 1e-9 * ends.back();
                                    }));
    if (has_targets && !problem.equilibrium->is_path_dependent())
      return improve_step();
    // The end of the history is judged as the result, after its load step was recorded.
    if (is_finished())
      return true;
    const ErrorControl &control = refinement.judge_on_path(position.cycle);
    if (has_targets)
      add_targets(control);
    return true;
  }



  template <int dim>
  void
  Simulation<dim>::add_targets(const ErrorControl &control)
  {
    const std::string why              = refinement.missed_targets(control);
    refinement.step_accuracy["met"]    = why.empty();
    refinement.step_accuracy["reason"] = why;
    recorder->add_targets(control, why, position.time);
  }



  // Meet the targets at one load step of the load history, by refinement of the mesh during the
  // run. Quantities below one hundredth of their final value are not resolved.
  template <int dim>
  bool
  Simulation<dim>::improve_step()
  {
    // A value that passes through zero has to be known only relative to its size at the end.
    constexpr double    small = 0.01;
    std::vector<double> least;
    for (const ErrorHistory &of_end : refinement.control.quantities())
      least.push_back(of_end.size() > 0 ? small * std::abs(of_end.last().value) : 0.);
    const bool         is_end = is_finished();
    ErrorControl       of_load(scene.goals, scene.refinement, least);
    ErrorControl      &its        = is_end ? refinement.control : of_load;
    const std::string  why_at_end = std::exchange(refinement.reason_targets_missed, {});
    const unsigned int most       = position.cycle + scene.maximum_cycles();
    for (;;)
      {
        refinement.n_steps = problem.report().steps.size();
        if (position.cycle == most)
          {
            refinement.step_accuracy =
              accuracy_results(scene.goals, its, refinement.judge(its, position.cycle));
            break;
          }
        if (!improve(its))
          break;
        ++position.cycle;
        problem.equilibrium->find_contact();
        report_set_up();
        if (!problem.solve(position.time, scene.newton.tolerance))
          return false;
      }
    if (is_end)
      return true;
    add_targets(of_load);
    refinement.reason_targets_missed = why_at_end;
    return true;
  }



  // Adaptive load steps: between prescribed times (`ends`) a step that does not converge is halved,
  // down to the shortest admissible one, and steps grow again by the number of Newton steps. Ends
  // since each step advances the time by at least the shortest length, or the loop is left. Returns
  // false if a step failed or `visit` ends it.
  template <int dim>
  bool
  Simulation<dim>::apply_load_history(const double                                  tolerance,
                                      Position                                     &from,
                                      const std::function<bool(unsigned int step)> &visit)
  {
    const std::vector<double> ends          = scene.load_steps.ends();
    double                    start         = 0;
    auto &[cycle, t, number, longest, path] = from;
    if (controls_path() && path.largest.tractions == 0)
      path.largest = largest_of_path(ends, tolerance);
    path_control.set_budget(path);
    for (const double end : ends)
      {
        const double shortest = scene.load_steps.shortest(end - start);
        // A cycle of the load within a step would not be seen.
        const double longest_with_friction =
          controls_path() ? (end - start) / 8 : std::numeric_limits<double>::max();
        start = end;
        while (t < end)
          {
            // A remainder that is longer than a step by rounding is taken at once.
            const double limit = std::min(longest, longest_with_friction);
            const double next  = end - t <= 1.001 * limit ? end : t + limit;
            if (ends.size() > 1 || next < end)
              out << "  load step " << number + 1 << ", t = " << next << std::endl;
            if (solve_step(next, tolerance, next - t > 1.999 * shortest))
              {
                longest =
                  my_path_error ?
                    path_control.growth() * (next - t) :
                    scene.load_steps.next_length(next - t, problem.report().steps.size(), longest);
                t              = next;
                path           = path_control.budget();
                shortest_tried = 0;
                if (!visit(++number))
                  return false;
              }
            else
              {
                longest = (next - t) / 2;
                // Smaller steps find the load at which friction is exceeded.
                if (longest < 0.999 * shortest ||
                    (problem.report().has_unconstrained_modes &&
                     !scene.contact.chosen().has_friction && !scene.contact.chosen().has_strength))
                  return false;
                if (my_path_error)
                  out << "  the path: halving the load step"
                      << (std::isfinite(*my_path_error) ?
                            ", whose halves change tangential tractions or work by " +
                              short_text(100 * *my_path_error, 2) + " % of the largest" :
                            ", in which loads turn")
                      << std::endl;
                else
                  out << "  no convergence (" << problem.report().reason
                      << (problem.report().tangent_is_indefinite ?
                            "; the tangent was not positive definite" :
                            "")
                      << "): halving the load step" << std::endl;
                shortest_tried = longest;
              }
          }
      }
    return true;
  }



  // Output of a load step; collective.
  template <int dim>
  void
  Simulation<dim>::record_step(const unsigned int step)
  {
    TimerOutput::Scope scope(timer, "output");
    recorder->add_contact_geometry(problem.equilibrium->neglected(),
                                   problem.equilibrium->uses_current_geometry());
    recorder->add_deformation(problem.neglected_work, problem.elasticity->is_finite_strain());
    recorder->add_path_error(my_path_error, problem.state.time);
    if (scene.contact.chosen().has_friction)
      recorder->add_deviation_of_loads(my_deviation, problem.state.time);
    Snapshot<dim> now = problem.equilibrium->snapshot(step);
    now.parts         = refinement.path_parts;
    if (after_step)
      after_step(now);
    recorder->add_step(now,
                       problem.report(),
                       problem.multigrid_cycles(),
                       std::exchange(refinement.step_accuracy, {}));
  }



#define INSTANTIATE(dim)                                                                           \
  template bool Simulation<dim>::solve_for_estimate();                                             \
  template void Simulation<dim>::return_to_start();                                                \
  template void Simulation<dim>::run_load_history();                                               \
  template bool Simulation<dim>::improve(ErrorControl &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
