// SPDX-License-Identifier: Apache-2.0
// Errors of histories that depend on their path: those of all load steps, and those of the path.
#include "driver/adaptive_refinement.h"
#include "output/accuracy_results.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace Signorini
{
  using namespace dealii;

  // Histories that depend on their path are solved on each mesh from the start, so that all load
  // steps have been judged on it when the end has.
  template <int dim>
  std::pair<const ErrorControl *, const ErrorEstimate *>
  AdaptiveRefinement<dim>::worst_load_step(ErrorControl        &control,
                                           const ErrorEstimate &of_end,
                                           const bool           path_is_final)
  {
    // The end may have met its target while another load step has not.
    const bool end_is_open = !control.is_met(true) && reason_targets_missed.empty();
    if (&control == &this->control && worst.control && !worst.control->is_met(true) &&
        worst.control->obstacle(path_is_final).empty() &&
        (!end_is_open || worst.control->excess_error() > control.excess_error()))
      return {worst.control, &worst.estimate};
    if (!end_is_open)
      return {nullptr, nullptr};
    return {&control, &of_end};
  }



  // The worst load step is one that a finer mesh can help.
  template <int dim>
  const ErrorControl &
  AdaptiveRefinement<dim>::judge_on_path(const unsigned int cycle)
  {
    // On the next mesh the same load step ends at the same time, unless load steps are automatic;
    // then it begins a history of its own.
    const auto [position, is_new] =
      steps_of_path.try_emplace(problem.state.time,
                                StepOfPath{ErrorControl(scene.goals, scene.refinement), cycle});
    StepOfPath         &step     = position->second;
    const ErrorEstimate estimate = estimate_errors();
    if (!is_new && step.judged_on == cycle)
      step.control.follow_path(estimate.quantities);
    else
      step.control.add(estimate.quantities);
    step.judged_on = cycle;
    step.control.set_least(least_on_path());
    report_errors(step.control);
    step_accuracy = accuracy_results(scene.goals, step.control, estimate);
    if (scene.goals.has_targets() && !step.control.is_met(true) &&
        step.control.obstacle(false).empty() &&
        (!worst.control || step.control.excess_error() > worst.control->excess_error()))
      {
        worst.control  = &step.control;
        worst.estimate = estimate;
      }
    return step.control;
  }



  template <int dim>
  void
  AdaptiveRefinement<dim>::judge_end(const unsigned int cycle)
  {
    of_end = judge(control, cycle);
  }



  template <int dim>
  bool
  AdaptiveRefinement<dim>::is_resolved(const unsigned int cycle) const
  {
    return control.is_resolved() &&
           std::all_of(steps_of_path.begin(), steps_of_path.end(), [&](const auto &entry) {
             return entry.second.judged_on != cycle || entry.second.control.is_resolved();
           });
  }



  template <int dim>
  void
  AdaptiveRefinement<dim>::add_path_errors(const unsigned int cycle, const double seconds)
  {
    last_mesh.at += seconds;
    for (auto &[time, step] : steps_of_path)
      if (step.judged_on == cycle)
        step.control.set_path(errors_of_path(time));
    const std::vector<double> at_end = errors_of_path(problem.state.time);
    const auto                set = [](ErrorEstimate &estimate, const std::vector<double> &sizes) {
      for (unsigned int i = 0; i < sizes.size(); ++i)
        estimate.quantities[i].parts.path = sizes[i];
    };
    if (of_end)
      set(*of_end, at_end);
    if (!end_judged_on)
      return;
    control.set_path(at_end);
    report_errors(control);
  }



  // Values that pass through zero, as after unloading, have to be known relative to a tenth of the
  // largest one of the history so far.
  template <int dim>
  std::vector<double>
  AdaptiveRefinement<dim>::least_on_path() const
  {
    constexpr double    small = 0.1;
    std::vector<double> least(scene.goals.quantities.size(), 0.);
    const auto          include = [&](const ErrorControl &judged) {
      for (unsigned int i = 0; i < least.size(); ++i)
        if (judged.quantities()[i].size() > 0)
          least[i] = std::max(least[i], small * std::abs(judged.quantities()[i].last().value));
    };
    for (const auto &[time, step] : steps_of_path)
      include(step.control);
    include(control);
    return least;
  }



  // The work of friction adds up, and the largest slip may be that of a former load step, of which
  // the dual problem of this one knows nothing.
  template <int dim>
  void
  AdaptiveRefinement<dim>::add_former_errors(ErrorEstimate &estimate) const
  {
    const auto next = steps_of_path.lower_bound(problem.state.time);
    if (next == steps_of_path.begin())
      return;
    const ErrorControl             &former = std::prev(next)->second.control;
    const std::vector<QuantityName> names  = problem.decisions.quantities();
    for (unsigned int i = 0; i < names.size(); ++i)
      {
        const ErrorHistory &history = former.quantities()[i];
        const double        bound =
          history.last_bounded().error_bound - history.last().parts.of_model_and_path();
        QuantityEstimate &one = estimate.quantities[i];
        if (names[i].what == "friction work")
          one.unresolved += bound;
        else if (names[i].what == "largest slip")
          one.unresolved = std::max(one.unresolved, bound);
      }
  }



  // Only where values of several meshes are compared, whose histories were all solved from the
  // start, are errors of former load steps seen.
  template <int dim>
  bool
  AdaptiveRefinement<dim>::lacks_former_steps() const
  {
    const auto &pairs = problem.decisions.pairs;
    return scene.load_steps.ends().size() > 1 && !control.quantities().empty() &&
           control.quantities()[0].size() == 1 &&
           (problem.elasticity->locks_rigid_bodies() || scene.contact.chosen().has_late_ties ||
            std::any_of(pairs.begin(), pairs.end(), [](const auto &pair) {
              return pair.friction.depends_on_time();
            }));
  }



  // Load steps between those for which the path was measured have the errors of the next one.
  template <int dim>
  std::vector<double>
  AdaptiveRefinement<dim>::errors_of_path(const double time) const
  {
    constexpr double rounding = 1e-9;
    if (path_errors.empty())
      return {};
    unsigned int step = 0;
    while (step + 1 < path_ends.size() && path_ends[step] < (1 - rounding) * time)
      ++step;
    return path_errors.errors(step, path_parts);
  }



#define INSTANTIATE(dim)                                                                           \
  template std::pair<const ErrorControl *, const ErrorEstimate *>                                  \
  AdaptiveRefinement<dim>::worst_load_step(ErrorControl &, const ErrorEstimate &, bool);           \
  template void                AdaptiveRefinement<dim>::judge_end(unsigned int);                   \
  template const ErrorControl &AdaptiveRefinement<dim>::judge_on_path(unsigned int);               \
  template bool                AdaptiveRefinement<dim>::is_resolved(unsigned int) const;           \
  template void                AdaptiveRefinement<dim>::add_path_errors(unsigned int, double);     \
  template std::vector<double> AdaptiveRefinement<dim>::least_on_path() const;                     \
  template void                AdaptiveRefinement<dim>::add_former_errors(ErrorEstimate &) const;  \
  template bool                AdaptiveRefinement<dim>::lacks_former_steps() const;                \
  template std::vector<double> AdaptiveRefinement<dim>::errors_of_path(double) const;
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
