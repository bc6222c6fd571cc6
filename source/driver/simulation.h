// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/interruption.h"
#include "checkpoint/checkpoints.h"
#include "driver/adaptive_refinement.h"
#include "output/recorder.h"
#include "scene/decisions.h"
#include "solver/newton.h"
#include <signorini/base/exit_code.h>

#include <deal.II/base/conditional_ostream.h>
#include <deal.II/base/timer.h>

#include <functional>
#include <limits>
#include <memory>
#include <optional>

namespace Signorini
{
  /// The position of a run in its sequence of meshes and load steps; the same on all ranks.
  struct Position
  {
    /// Number of refined meshes before the present one.
    unsigned int cycle = 0;
    /// Time of the last solved load step; load steps start on the last mesh.
    double time = 0;
    /// Number of load steps up to that time.
    unsigned int step = 0;
    /// Largest length of the next load step, after cut-backs.
    double longest = std::numeric_limits<double>::max();
  };

  /// One run: read scene, make mesh, solve, estimate errors, refine; then the load history and the
  /// results. All functions are collective.
  template <int dim>
  class Simulation
  {
  public:
    /// @param out stream for messages of the first rank
    /// @param is_restart continue an earlier run from its output directory
    Simulation(const Scene<dim> &scene, MPI_Comm comm, std::ostream &out, bool is_restart = false);

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
    /// Meet the targets at a load step, on finer meshes if necessary; at the last one if other load
    /// steps have changed the mesh since it was estimated. Returns false if the step cannot be
    /// solved on a finer mesh.
    bool
    improve_step();

    // Checkpoints, in simulation_restart.cc:

    /// The exit code of the run in the output directory, if that run is finished.
    std::optional<ExitCode>
    code_of_finished_run() const;
    /// Find the checkpoint of a restart; otherwise write the origin of the run.
    void
    find_checkpoint();
    /// Restore what the program has decided in the earlier run.
    void
    restore_decisions();
    /// Refine the mesh as it was at the checkpoint.
    void
    restore_mesh();
    /// Restore state, search tolerances, counters and error history.
    void
    restore_state();
    /// True if nothing is left to be solved.
    bool
    is_finished() const;
    /// Mark a state from which a restart can continue, and write a checkpoint if it is time for
    /// one.
    void
    pass_checkpoint();
    /// Write a checkpoint of the last such state. Collective.
    void
    write_checkpoint();
    /// Write a checkpoint for a run that ends without a solution.
    void
    write_final_checkpoint();
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

    /// The state of a checkpoint, without the results: a copy, since attempts to solve change the
    /// original.
    struct CheckpointState
    {
      State state;
      Json  head; ///< the same on all ranks
    };
    const bool is_restart;
    bool       is_interrupted = false;
    /// True from the restart of a run until something is solved.
    bool is_restored = false;
    /// True if something has been solved since the start of this process.
    bool                                has_progressed = false;
    Position                            position;
    std::unique_ptr<Checkpoints>        checkpoints;
    std::unique_ptr<Interruption>       interruption;
    std::uint32_t                       origin = 0; ///< checksum_of_origin()
    std::optional<Checkpoints::Content> former;     ///< until it is restored
    std::optional<CheckpointState>      checkpoint_state;
    double                              written_at     = 0; ///< seconds: the last checkpoint
    unsigned int                        steps_since    = 0;
    double                              shortest_tried = 0; ///< load step since the last solved one
  };
} // namespace Signorini
