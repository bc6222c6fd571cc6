// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "accuracy/error_control.h"
#include "accuracy/error_estimate.h"
#include "accuracy/path_errors.h"
#include "driver/problem.h"
#include "output/recorder.h"

#include <deal.II/base/timer.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace Signorini
{
  /// Estimates errors, and refines the mesh or raises degrees until the targets are met or cannot
  /// be. All functions are collective.
  template <int dim>
  class AdaptiveRefinement
  {
  public:
    /// Keeps references to all arguments but the communicator.
    /// @param clock wall time since the start of the run
    AdaptiveRefinement(const Scene<dim>           &scene,
                       Problem<dim>               &problem,
                       MPI_Comm                    comm,
                       dealii::ConditionalOStream &out,
                       dealii::TimerOutput        &timer,
                       const dealii::Timer        &clock);

    /// Estimate the errors of the last solution, and refine the mesh.
    /// @param cycle number of the present mesh
    /// @param control history of the solutions of that load on all meshes
    /// @return false if no better mesh is needed or possible: the last solution is on the last mesh
    bool
    improve(ErrorControl &control, unsigned int cycle, Recorder<dim> &recorder);
    /// Estimate the errors of the last solution and add them to the history. A mesh that was
    /// refined for other load steps is no new mesh for the end: the change of its values indicates
    /// nothing about refinement for the end.
    ErrorEstimate
    judge(ErrorControl &control, unsigned int cycle);
    /// Estimate the errors of a load step before the end, of a history that depends on its path
    /// and is solved on each mesh. improve() refines for that of them whose errors are too large by
    /// the largest factor, if that of the end is smaller.
    /// @return the history of its solutions on all meshes
    const ErrorControl &
    judge_on_path(unsigned int cycle);
    /// Before a history that depends on its path: its load steps are judged anew.
    void
    begin_history()
    {
      worst = {};
    }
    /// Estimate the errors at the end of a history that depends on its path, for improve().
    void
    judge_end(unsigned int cycle);
    /// @return whether the present mesh has met the targets at all load steps that were judged on
    /// it, but for the errors of path and model.
    bool
    is_resolved(unsigned int cycle) const;
    /// Take over path_errors, that have been measured since the load steps were judged.
    /// @param seconds that this has taken, which are not those of a mesh
    void
    add_path_errors(unsigned int cycle, double seconds);
    /// After the last mesh on which the targets could have been met. @return why they were not met,
    /// for a message; empty: they are
    std::string
    missed_targets(const ErrorControl &control) const;
    /// Estimate the errors of the last load step.
    void
    estimate_result(unsigned int cycle, Recorder<dim> &recorder);
    /// Newton steps on a mesh that is to be refined.
    unsigned int n_steps = 0;
    /// Error history of the end of the load history.
    ErrorControl control;
    /// Tolerance of Newton's method on the next mesh.
    double tolerance;
    /// The number of the mesh on which the end was judged last, unless one was made for it since.
    std::optional<unsigned int> end_judged_on;
    /// The accuracy of the last load step, for its results; null: not estimated.
    Json step_accuracy;
    /// Errors of the quantities by the length of load steps; empty: not measured, or none.
    PathErrors path_errors;
    /// Ends of the load steps to which they belong.
    std::vector<double> path_ends;
    /// Ends of the load steps of the last history that was judged, and the quantities there.
    std::vector<double> history_ends;
    PathErrors::Values  history_values;
    /// The number of the mesh on which the errors of the path were measured, and whether it
    /// resolved the quantities.
    std::optional<unsigned int> path_measured_on;
    bool                        path_was_resolved = false;
    /// The number of equal parts in which each load step is solved, if the path matters.
    unsigned int path_parts = 1;
    /// Why targets were missed, for a message; empty: no reason is known.
    std::string reason_targets_missed;

  private:
    /// Choose the cells to be refined, or the bodies whose degree is raised. Returns false if a
    /// limit forbids the next mesh.
    bool
    mark(const ErrorControl &control, const ErrorEstimate &estimate);
    /// Print the quantities with their error bounds.
    void
    report_errors(const ErrorControl &control);
    /// The estimated errors of the last solution. Collective.
    ErrorEstimate
    estimate_errors();
    /// The errors of the path at a time; empty: none are known.
    std::vector<double>
    errors_of_path(double time) const;
    /// Smallest sizes of the quantities to which targets are relative, of histories that depend on
    /// their path.
    std::vector<double>
    least_on_path() const;
    /// @return whether the state keeps what the mesh made wrong in former load steps, and the bars
    /// do not contain it.
    bool
    lacks_former_steps() const;
    /// Add the errors of quantities that accumulate, at the end of the load step before.
    void
    add_former_errors(ErrorEstimate &estimate) const;
    /// The control and estimate for which the mesh is refined: those of the end, or of the load
    /// step of the path whose error is too large by a larger factor. Null: none is too large, or
    /// finer meshes would not help.
    /// @param of_end estimate of the end
    /// @param path_is_final whether load steps cannot be shorter than they are
    std::pair<const ErrorControl *, const ErrorEstimate *>
    worst_load_step(ErrorControl &control, const ErrorEstimate &of_end, bool path_is_final);

    const Scene<dim>           &scene;
    Problem<dim>               &problem;
    const MPI_Comm              comm;
    dealii::ConditionalOStream &out;
    dealii::TimerOutput        &timer;
    const dealii::Timer        &clock;

    /// A load step of the path before the end.
    struct StepOfPath
    {
      ErrorControl control;
      unsigned int judged_on; ///< number of the mesh
    };

    /// By the time of their ends.
    std::map<double, StepOfPath> steps_of_path;
    /// Of those on the present mesh the one with the largest errors, and its estimate.
    struct
    {
      const ErrorControl *control = nullptr;
      ErrorEstimate       estimate;
    } worst;

    /// The estimate of the end, if judge_end() has made it on the present mesh.
    std::optional<ErrorEstimate> of_end;

    /// What the next mesh is expected to take, for its results.
    Json next_mesh;
    /// Memory of all ranks before there was a mesh [MB].
    const double memory_at_start;
    /// @return the seconds that a mesh is expected to take. To be called once for each mesh.
    /// @param dofs its number of degrees of freedom
    double
    seconds_of_next(double dofs);
    /// The last mesh: wall time at which it was estimated [s], what it took, its size.
    struct
    {
      double at = 0, seconds = 0, dofs = 0;
    } last_mesh;
    /// Bodies whose degree becomes 2 on the next mesh.
    std::vector<unsigned int> next_quadratic;
  };
} // namespace Signorini
