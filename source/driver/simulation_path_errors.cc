// SPDX-License-Identifier: Apache-2.0
// The errors of quantities by the length of load steps, and how many parts of load steps they need.
#include "driver/simulation.h"
#include <signorini/base/text.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  std::vector<double>
  Simulation<dim>::quantity_values()
  {
    const Snapshot<dim> now = problem.equilibrium->snapshot(0);
    std::vector<double> result;
    for (const QuantityName &name : problem.decisions.quantities())
      result.push_back(functional(name, now, scene.output.probes).value);
    return result;
  }



  template <int dim>
  bool
  Simulation<dim>::solve_in_parts(const double t, const unsigned int parts, const double tolerance)
  {
    // Parts are equal in time, since loads and motions are functions of it.
    const double from = problem.state.time;
    for (unsigned int k = 1; k <= parts; ++k)
      {
        const double end = k == parts ? t : from + k * (t - from) / parts;
        if (!(scene.contact.chosen().has_friction ? solve_following_turn(end, tolerance) :
                                                    problem.solve(end, tolerance)))
          return false;
      }
    return true;
  }



  template <int dim>
  bool
  Simulation<dim>::solve_in_parts(const std::vector<double> &ends,
                                  const unsigned int         parts,
                                  const double               tolerance,
                                  PathErrors::Values        &values)
  {
    return_to_start();
    for (const double end : ends)
      {
        // As for the load steps of the run, what is left of one that does not converge is taken in
        // twice as many parts, from the last one that has converged.
        const double start = problem.state.time;
        unsigned int left  = parts;
        for (unsigned int cuts = 0; !solve_in_parts(end, left, tolerance); ++cuts)
          {
            if (cuts == scene.load_steps.cut_backs)
              return false;
            const double share = (end - problem.state.time) / (end - start);
            left =
              std::max(2u, static_cast<unsigned int>(std::ceil((parts << (cuts + 1)) * share)));
          }
        values.push_back(quantity_values());
      }
    return true;
  }



  // A third of the targets is for the path. Values that pass through zero, as after unloading, have
  // to be known relative to a tenth of the largest one of the history.
  template <int dim>
  bool
  Simulation<dim>::is_path_accurate(const PathErrors::Values &values,
                                    const unsigned int        parts) const
  {
    constexpr double    share = 0.3, small = 0.1;
    std::vector<double> least(scene.goals.quantities.size(), 0.);
    for (const std::vector<double> &at_step : values)
      for (unsigned int i = 0; i < least.size(); ++i)
        least[i] = std::max(least[i], small * std::abs(at_step[i]));
    for (unsigned int step = scene.goals.judge_all_steps() ? 0 : values.size() - 1;
         step < values.size();
         ++step)
      {
        const std::vector<double> errors = refinement.path_errors.errors(step, parts);
        for (unsigned int i = 0; i < errors.size(); ++i)
          if (errors[i] >
              share * scene.goals.targets[i] * std::max(std::abs(values[step][i]), least[i]))
            return false;
      }
    return true;
  }



  // The dual problem of each load step sees its own errors alone, so that load steps are solved
  // with the tolerance of the end.
  template <int dim>
  bool
  Simulation<dim>::solve_and_judge_history()
  {
    Position start;
    refinement.n_steps = 0;
    judging_seconds    = 0;
    refinement.begin_history();
    refinement.history_ends.clear();
    refinement.history_values.clear();
    return_to_start();
    if (!apply_load_history(scene.newton.tolerance, start, [&](auto) {
          refinement.n_steps += problem.report().steps.size();
          refinement.history_ends.push_back(start.time);
          refinement.history_values.push_back(quantity_values());
          const double before = clock.wall_time();
          if (scene.goals.judge_all_steps() && start.time < scene.load_steps.end_time)
            refinement.judge_on_path(position.cycle);
          judging_seconds += clock.wall_time() - before;
          return true;
        }))
      return false;
    refinement.judge_end(position.cycle);
    return true;
  }



  // Meshes that are too coarse need no accurate path. On the first one that is fine enough load
  // steps get as many parts as the targets need, and the history is solved again with them.
  template <int dim>
  bool
  Simulation<dim>::solve_path_for_estimate()
  {
    if (!solve_and_judge_history())
      return false;
    if (!needs_path_errors(false))
      return true;
    const unsigned int parts = refinement.path_parts;
    measure_path_errors(false);
    return parts == refinement.path_parts || controls_path() || solve_and_judge_history();
  }



  // What was measured on a mesh that resolved the quantities is kept while the path hardly matters.
  template <int dim>
  bool
  Simulation<dim>::needs_path_errors(const bool is_last) const
  {
    constexpr double small = 0.1;
    if (scene.goals.quantities.empty() || !problem.equilibrium->has_path_errors() ||
        refinement.path_measured_on == position.cycle)
      return false;
    if (refinement.path_errors.empty())
      return true;
    const std::vector<ErrorHistory> &histories = refinement.control.quantities();
    if (refinement.path_was_resolved &&
        std::all_of(histories.begin(), histories.end(), [&](const ErrorHistory &history) {
          return history.size() > 0 &&
                 history.last().parts.path <= small * history.last_bounded().error_bound;
        }))
      return false;
    return is_last || refinement.is_resolved(position.cycle);
  }



  // The load history with its load steps, with halves and with quarters of them, (8.18). With
  // automatic load steps the solution is that of halves, see solve_step().
  template <int dim>
  void
  Simulation<dim>::measure_path_errors(const bool is_last)
  {
    constexpr double small       = 0.1;
    const double     begin       = clock.wall_time();
    const bool       has_targets = scene.goals.has_targets(),
               is_fine           = has_targets && refinement.is_resolved(position.cycle);
    unsigned int &parts          = refinement.path_parts;
    if (controls_path())
      parts = 2;
    const unsigned int first = std::max(1u, parts / 2);
    // Three histories tell the rate at which the error decreases, two follow it. On a mesh that is
    // too coarse for the targets anyway, two give an idea.
    const unsigned int n_histories =
      refinement.path_errors.knows_rate() || (has_targets && !is_fine && !is_last) ? 2 : 3;
    out << "  the path: the load steps in " << first << ", " << 2 * first
        << (n_histories == 2 ? "" : ", " + std::to_string(4 * first)) << " parts" << std::endl;
    const double tolerance = scene.newton.tolerance;
    const State  before    = problem.state;
    bool         is_solved = true;
    // The present load steps were solved for the estimate already, unless there was none.
    refinement.path_ends     = refinement.history_ends;
    PathErrors::Values known = refinement.history_values;
    if (refinement.end_judged_on != position.cycle || known.empty())
      {
        known.clear();
        refinement.path_ends.clear();
        Position start;
        return_to_start();
        is_solved = apply_load_history(tolerance, start, [&](auto) {
          refinement.path_ends.push_back(start.time);
          known.push_back(quantity_values());
          return true;
        });
      }
    std::vector<PathErrors::Values> values;
    double                          seconds_of_part = 0;
    for (unsigned int k = 0; is_solved && k < n_histories; ++k)
      if ((first << k) == parts)
        values.push_back(known);
      else
        {
          const double started = clock.wall_time();
          values.emplace_back();
          is_solved = solve_in_parts(refinement.path_ends, first << k, tolerance, values.back());
          seconds_of_part = (clock.wall_time() - started) / (first << k);
        }

    // A path that could not be followed with shorter steps is not known at all.
    if (!is_solved)
      values = {known};
    for (PathErrors::Values &history : values)
      history.resize(std::max<std::size_t>(1, refinement.path_ends.size()),
                     std::vector<double>(scene.goals.quantities.size(),
                                         std::numeric_limits<double>::max()));
    refinement.path_errors.set(is_solved ? first : parts, values);
    refinement.path_measured_on = position.cycle;
    if (has_targets && is_solved && !controls_path() && (is_fine || is_last))
      parts = choose_parts(first, values, is_fine, seconds_of_part);
    problem.equilibrium->return_to(before);
    if (parts > 1 && !controls_path())
      out << "  the path: each load step is solved in " << parts << " parts" << std::endl;
    refinement.add_path_errors(position.cycle, clock.wall_time() - begin);
    const std::vector<ErrorHistory> &histories = refinement.control.quantities();
    // Two histories may agree by chance.
    refinement.path_was_resolved =
      refinement.path_errors.knows_rate() &&
      std::all_of(histories.begin(), histories.end(), [&](const ErrorHistory &history) {
        return history.size() > 0 &&
               history.last_bounded().error_bound - history.last().parts.path <=
                 small * std::abs(history.last().value);
      });
  }



  // On a mesh that is fine enough for the targets, histories with twice as many parts are added
  // until the next one is expected to be accurate: a rate is not trusted for more than one
  // doubling.
  template <int dim>
  unsigned int
  Simulation<dim>::choose_parts(const unsigned int               first,
                                std::vector<PathErrors::Values> &values,
                                const bool                       adds_histories,
                                double                           seconds_of_part)
  {
    constexpr unsigned int most = 64;
    // The parts of the last history, and those that are worth their time.
    unsigned int tried = first << (values.size() - 1), reach = 0;
    for (;;)
      {
        const unsigned int in_time = std::min(most, parts_in_time(seconds_of_part));
        reach                      = std::min(2 * tried, in_time);
        if (!adds_histories || 4 * tried > in_time || is_path_accurate(values.back(), 2 * tried))
          break;
        tried *= 2;
        out << "  the path: the load steps in " << tried << " parts" << std::endl;
        const double       begin = clock.wall_time();
        PathErrors::Values more;
        // What has no solution with shorter load steps keeps those that it has.
        if (!solve_in_parts(refinement.path_ends, tried, scene.newton.tolerance, more))
          break;
        seconds_of_part = (clock.wall_time() - begin) / tried;
        values.push_back(more);
        refinement.path_errors.set(first, values);
      }
    // Never fewer than now: the values of this mesh were found with these.
    unsigned int parts = refinement.path_parts;
    while (2 * parts <= reach && !is_path_accurate(values.back(), parts))
      parts *= 2;
    return parts;
  }



  // The history is solved twice with these parts: for its estimate and for its results.
  template <int dim>
  unsigned int
  Simulation<dim>::parts_in_time(const double seconds_of_part) const
  {
    constexpr unsigned int most  = 1u << 20;
    const double           limit = 60 * scene.goals.time_limit;
    if (limit == 0 || seconds_of_part == 0)
      return most;
    const double left = limit - clock.wall_time() - 2 * judging_seconds;
    return static_cast<unsigned int>(
      Utilities::MPI::min(std::clamp(left / (2 * seconds_of_part), 0., double(most)), comm));
  }



#define INSTANTIATE(dim)                                                                           \
  template std::vector<double> Simulation<dim>::quantity_values();                                 \
  template bool                Simulation<dim>::solve_in_parts(double, unsigned int, double);      \
  template bool                Simulation<dim>::solve_path_for_estimate();                         \
  template bool                Simulation<dim>::needs_path_errors(bool) const;                     \
  template void                Simulation<dim>::measure_path_errors(bool);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
