// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/interruption.h"
#include "driver/path_control.h"
#include "driver/run_checkpoints.h"
#include "scene/decisions.h"
#include "solver/newton.h"
#include <signorini/base/exit_code.h>

#include <deal.II/base/conditional_ostream.h>
#include <deal.II/base/timer.h>

#include <functional>
#include <memory>
#include <optional>

namespace Signorini
{
  /// One run: read scene, make mesh, solve, estimate errors, refine; then the load history and the
  /// results. All functions are collective.
  template <int dim>
  class Simulation
  {
  public:
    /// @param out stream for messages of the first rank
    /// @param origin what the run starts from
    Simulation(const Scene<dim> &scene,
               MPI_Comm          comm,
               std::ostream     &out,
               RunOrigin         origin = RunOrigin::scene_file);

    /// Check and print what would be solved, without solving. Throws SceneError.
    void
    preflight();

    /// Run, with results in files. @return the exit code
    ExitCode
    run();

    /// Called after each load step of the last mesh, if it is not empty. Collective.
    std::function<void(const Snapshot<dim> &)> after_step;

  private:
    // Functions in the order in which they are called.
    ExitCode
    solve_scene();
    void
    set_up();
    void
    report_set_up();
    /// Check probes and expected results before anything is solved. Throws SceneError.
    void
    check_requests();
    /// Solve the end of the load history on a mesh that is still to be refined.
    bool
    solve_for_estimate();
    /// Return to the undeformed state.
    void
    return_to_start();
    /// Solve all load steps on the last mesh.
    void
    run_load_history();
    /// Solve all load steps, with shorter ones where a step cannot be solved.
    /// @param from in: where they start; out: where they are
    /// @param visit called after each step; returns false to end
    bool
    apply_load_history(double                                        tolerance,
                       Position                                     &from,
                       const std::function<bool(unsigned int step)> &visit);
    /// Solve a load step; with friction and automatic steps so short that the path is accurate.
    /// Returns false if it is to be halved.
    /// @param may_be_halved whether it is longer than the shortest one
    bool
    solve_step(double t, double tolerance, bool may_be_halved);
    /// The present solution as far as it depends on the path. Collective.
    PathControl::Solution
    solution_of_path() const;
    /// Estimate the largest sizes in the rest of the load history. Does not change the state.
    /// Collective.
    /// @param ends of the load steps that the scene asks for
    PathControl::Size
    largest_of_path(const std::vector<double> &ends, double tolerance);
    /// Solve a load step with friction in as many parts as are needed to follow the turn of
    /// obstacles: slip is the straight way of a load step along the tangents at its end.
    bool
    solve_following_turn(double t, double tolerance);
    /// Solve a load step with friction, divided where surfaces first meet.
    bool
    solve_from_touch(double t, double tolerance);
    /// Solve the whole load history on a mesh, and estimate the errors of all load steps, with that
    /// of the path if the mesh is fine enough. Returns false if a load step has no solution.
    bool
    solve_path_for_estimate();
    /// Solve the load history with the present parts of load steps, and estimate their errors.
    bool
    solve_and_judge_history();
    /// @return whether the errors of the path are to be measured on the present mesh.
    /// @param is_last whether no other mesh follows
    bool
    needs_path_errors(bool is_last) const;
    /// Measure by how much the quantities change with the length of the load steps, on the present
    /// mesh, and choose the number of parts of load steps. Does not change the state.
    /// @param is_last whether no other mesh follows
    void
    measure_path_errors(bool is_last);
    /// Solve the load history from the undeformed state, each load step in equal parts.
    /// @param ends of the load steps
    /// @param values of the quantities at all ends: out
    /// @return whether all could be solved
    bool
    solve_in_parts(const std::vector<double> &ends,
                   unsigned int               parts,
                   double                     tolerance,
                   PathErrors::Values        &values);
    /// Solve a load step in a number of equal parts.
    bool
    solve_in_parts(double t, unsigned int parts, double tolerance);
    /// @return whether the path errors are small beside the targets.
    /// @param values of the quantities
    /// @param parts of load steps: a power of two times those of the first history that was
    /// measured
    bool
    is_path_accurate(const PathErrors::Values &values, unsigned int parts) const;
    /// @return the number of parts in which load steps are to be solved for the targets.
    /// Collective.
    /// @param first number of parts of the first history
    /// @param values of histories, each with twice as many parts; more may be added
    /// @param adds_histories whether that is worth its time on this mesh
    /// @param seconds_of_part of the last history
    unsigned int
    choose_parts(unsigned int                     first,
                 std::vector<PathErrors::Values> &values,
                 bool                             adds_histories,
                 double                           seconds_of_part);
    /// The number of parts of load steps that the time limit leaves room for.
    /// @param seconds_of_part that a history takes for each of them
    unsigned int
    parts_in_time(double seconds_of_part) const;
    /// The values of the quantities at the present solution.
    std::vector<double>
    quantity_values();
    /// True if load steps are chosen for the accuracy of the path.
    bool
    controls_path() const;
    /// Write the results of a load step.
    void
    record_step(unsigned int step);
    /// Solve the bodies without contact, and record the ratio of costs.
    void
    compare_with_linear_solve();
    /// Write the results and the messages of the end. @return the exit code
    ExitCode
    finish(NewtonReport end);

    /// Refine the mesh, see AdaptiveRefinement::improve().
    bool
    improve(ErrorControl &control);
    /// Estimate the errors of a load step of the last mesh, and meet the targets. Returns false if
    /// it cannot be solved on a finer mesh.
    bool
    judge_step();
    /// Record whether a load step has met the targets.
    void
    add_targets(const ErrorControl &control);
    /// Meet the targets at a load step, on finer meshes if necessary; at the last one if other load
    /// steps have changed the mesh since it was estimated. Returns false if the step cannot be
    /// solved on a finer mesh.
    bool
    improve_step();

    /// True if nothing is left to be solved.
    bool
    is_finished() const;
    /// Mark a state from which a restart can continue, and write a checkpoint if it is time for
    /// one.
    void
    pass_checkpoint();
    /// The visitor of Newton steps: prints, and checks for interruption.
    StepVisitor
    watch();

    const Scene<dim>           scene;
    const MPI_Comm             comm;
    dealii::ConditionalOStream out;
    dealii::TimerOutput        timer;
    /// Wall time since the start.
    dealii::Timer clock;

    Problem<dim>            problem;
    AdaptiveRefinement<dim> refinement;
    /// Null if nothing is written (preflight).
    std::unique_ptr<Recorder<dim>> recorder;
    bool                           only_checks = false;

    const RunOrigin                      origin;
    bool                                 is_interrupted = false;
    Position                             position;
    std::unique_ptr<RunCheckpoints<dim>> checkpoints; ///< null if nothing is written
    std::unique_ptr<Interruption>        interruption;
    double shortest_tried = 0; ///< load step since the last solved one

    /// The first half of a load step whose length was rejected.
    struct FirstHalf
    {
      double                from, to;
      PathControl::Solution solution;
    };

    PathControl              path_control;
    std::optional<FirstHalf> first_half; ///< of the load step before, if it is known
    double judging_seconds = 0;          ///< of the load steps before the end, on the present mesh
    std::optional<double> my_path_error; ///< of the last load step, if it was estimated
    /// Of the loads in the last load step, see Equilibrium::deviation_of_loads(), if load steps are
    /// not chosen for the accuracy of the path.
    double my_deviation = 0;
  };
} // namespace Signorini
