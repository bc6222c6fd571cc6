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
  unsigned int
  Simulation<dim>::parts_for_targets(const PathErrors::Values &values,
                                     const unsigned int        first,
                                     const unsigned int        most) const
  {
    constexpr double    share = 0.3, small = 0.1;
    std::vector<double> least(scene.goals.quantities.size(), 0.);
    for (const std::vector<double> &at_step : values)
      for (unsigned int i = 0; i < least.size(); ++i)
        least[i] = std::max(least[i], small * std::abs(at_step[i]));
    const auto is_enough = [&](const unsigned int parts) {
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
    };
    // Powers of two times the first number: those for which errors() knows changes.
    unsigned int parts = first;
    while (parts < most && !is_enough(parts))
      parts *= 2;
    return parts;
  }



  // The load history with its load steps, with halves and with quarters of them, (8.18). With
  // automatic load steps the solution is that of halves, see solve_step().
  template <int dim>
  void
  Simulation<dim>::measure_path_errors()
  {
    if (scene.goals.quantities.empty() || !problem.equilibrium->is_path_dependent() ||
        refinement.end_judged_on == position.cycle)
      return;
    // What was measured on the mesh before is kept, if that mesh resolved the quantities and the
    // path hardly mattered; if it mattered, the rate at which the errors decrease is kept.
    constexpr double                 small     = 0.1;
    constexpr unsigned int           most      = 64;
    const std::vector<ErrorHistory> &histories = refinement.control.quantities();
    const auto                       of_all    = [&](const auto &holds) {
      return !refinement.path_errors.empty() &&
             std::all_of(histories.begin(), histories.end(), [&](const ErrorHistory &history) {
               return history.size() > 0 && holds(history.last_bounded().error_bound,
                                                  history.last().parts.path,
                                                  std::abs(history.last().value));
             });
    };
    const bool is_resolved = of_all([](const double bound, const double path, const double value) {
      return bound - path <= small * value;
    }),
               hardly_matters = of_all([](const double bound, const double path, double) {
                 return path <= small * bound;
               });
    if (is_resolved && hardly_matters)
      return;

    // Two histories suffice to follow an error whose rate is known; three tell the rate.
    unsigned int      &parts       = refinement.path_parts;
    const unsigned int n_histories = is_resolved ? 2 : 3;
    // Not beyond the limit with the finest of three histories either.
    unsigned int first = is_resolved ? std::max(1u, parts / 2) : std::min(parts, most / 4);
    out << "  the path: the load steps in " << first << ", " << 2 * first
        << (n_histories == 2 ? "" : ", " + std::to_string(4 * first)) << " parts" << std::endl;
    // The tolerances of estimates on coarse meshes would hide the path.
    const double tolerance = scene.newton.tolerance;
    const State  before    = problem.state;
    return_to_start();
    Position start;
    parts = first;
    refinement.path_ends.clear();
    std::vector<PathErrors::Values> values(1);
    bool                            is_solved = apply_load_history(tolerance, start, [&](auto) {
      refinement.path_ends.push_back(start.time);
      values[0].push_back(quantity_values());
      return true;
    });
    // The control has solved each load step in two parts already; one part is the coarser history.
    if (controls_path())
      {
        first     = 1;
        parts     = 2;
        values    = {{}, values[0]};
        is_solved = is_solved && solve_in_parts(refinement.path_ends, 1, tolerance, values[0]);
      }
    while (is_solved && values.size() < n_histories)
      {
        values.emplace_back();
        is_solved = solve_in_parts(refinement.path_ends,
                                   first << (values.size() - 1),
                                   tolerance,
                                   values.back());
      }
    problem.equilibrium->return_to(before);

    // A path that could not be followed with shorter steps is not known at all.
    if (!is_solved)
      values = {values[controls_path() && !values[1].empty() ? 1 : 0]};
    for (PathErrors::Values &history : values)
      history.resize(std::max<std::size_t>(1, refinement.path_ends.size()),
                     std::vector<double>(histories.size(), std::numeric_limits<double>::max()));
    refinement.path_errors.set(first, values);
    if (scene.goals.has_targets() && is_solved && !controls_path())
      parts =
        parts_for_targets(values.back(), first, is_resolved ? most : first << (n_histories - 1));
    if (parts > 1 && !controls_path())
      out << "  the path: each load step is solved in " << parts << " parts" << std::endl;
  }



#define INSTANTIATE(dim)                                                                           \
  template std::vector<double> Simulation<dim>::quantity_values();                                 \
  template bool                Simulation<dim>::solve_in_parts(double, unsigned int, double);      \
  template void                Simulation<dim>::measure_path_errors();
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
