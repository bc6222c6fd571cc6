// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "accuracy/error_control.h"
#include "accuracy/refinement.h"
#include "base/interruption.h"
#include "checkpoint/checkpoints.h"
#include "driver/equilibrium.h"
#include "driver/state.h"
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
    unsigned int cycle   = 0; ///< meshes that were refined
    double       time    = 0; ///< of the load history, which begins on the last mesh
    unsigned int step    = 0; ///< load steps up to that time
    double       longest = std::numeric_limits<double>::max(); ///< of load steps, as they were cut
  };

  /// One run: scene -> mesh -> solve -> estimate -> refine -> load history -> results.
  template <int dim>
  class Simulation
  {
  public:
    /// @param out where the first rank reports
    /// @param is_restart with what an earlier run left in the output directory
    Simulation(const Scene<dim> &scene, MPI_Comm comm, std::ostream &out, bool is_restart = false);

    /// Print what will be solved, and solve nothing.
    void
    preflight();

    ExitCode
    run();

    /// Called after each load step of the last mesh, if it is not empty. Collective.
    std::function<void(const Snapshot<dim> &)> after_step;

  private:
    // In the order in which they happen.
    ExitCode
    solve_scene();
    void
    set_up();
    /// Set up the contact interfaces for the present bodies.
    void
    set_up_contact();
    void
    report_set_up();
    /// Check probes and expected results before anything is solved. Throws SceneError.
    void
    check_requests();
    /// Solve the end of the load history on a mesh that is still to be refined.
    bool
    solve_for_estimate();
    /// Solve at time t, starting from the last state; at finite strain where that is needed, see
    /// simulation_deformation.cc.
    bool
    solve(double t, double tolerance);
    /// Change to the supports that act at time t, on the same mesh and from the same state;
    /// whatever depends on the constraints is rebuilt.
    void
    change_supports(double t);
    void
    run_load_history();
    /// Solve all load steps, with shorter ones where a step cannot be solved.
    /// @param from in: where they start; out: where they are
    /// @param visit called after each step; returns false to end
    bool
    apply_load_history(double                                        tolerance,
                       Position                                     &from,
                       const std::function<bool(unsigned int step)> &visit);
    void
    record_step(unsigned int step);
    const NewtonReport &
    report() const
    {
      return equilibrium->report();
    }
    /// Multigrid cycles of the solves on this mesh.
    unsigned int
    multigrid_cycles() const;
    double
    mesh_seconds() const;
    void
    compare_with_linear_solve();
    ExitCode
    finish(NewtonReport end);

    // Small or large deformation, in simulation_deformation.cc:

    /// True if the error of small strain in the last solution is acceptable. Collective.
    bool
    is_small_enough();
    /// Switch to finite strain. Throws SceneError where the model uses features of small strain
    /// only.
    void
    switch_to_finite_strain(const State &before);
    /// Replace the elasticity on the same mesh. @param known ContactInterfaces::save()
    void
    replace_elasticity(std::unique_ptr<Elasticity<dim>> other,
                       const State                     &carried,
                       bool                             uses_current_geometry,
                       const Json                      &known);

    // Errors, in simulation_accuracy.cc:

    /// Estimate the errors of the last solution, and refine the mesh. False if that is not needed,
    /// or of no use: the last solution is on the last mesh.
    /// @param control of the solutions of that load on all meshes
    bool
    improve(ErrorControl &control);
    /// Which cells are refined, or which bodies enriched. False if the next mesh cannot be had.
    bool
    mark(const ErrorControl &control, const ErrorEstimate &estimate);
    /// Meet the targets at a load step, on finer meshes if it has to be; at the last one, where
    /// others have changed the mesh since it was judged. False if that is not solved.
    bool
    improve_step();
    /// Degree 2 for these bodies, on the same mesh.
    void
    p_refine(const std::vector<unsigned int> &bodies);
    /// Of the last solution, on one mesh more. A mesh that was refined for other load steps is none
    /// more to the end: what its values change by says nothing of what refinement for it would.
    ErrorEstimate
    judge(ErrorControl &control);
    void
    report_errors(const ErrorControl &control);
    /// After the last mesh on which the targets could have been met. @return why they were not, in
    /// words; empty: they are
    std::string
    missed_targets(const ErrorControl &control) const;
    /// Estimate the errors of the last load step.
    void
    estimate_result();
    /// The estimated errors of the last solution. Collective.
    ErrorEstimate
    estimate_errors();

    // Checkpoints, in simulation_restart.cc:

    /// The exit code of the run in the output directory, if that run is finished.
    std::optional<ExitCode>
    code_of_finished_run() const;
    void
    find_checkpoint();
    void
    restore_decisions();
    /// The mesh as it was.
    void
    restore_mesh();
    /// All the rest, but for the results.
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
    Decisions<dim>             decisions;
    const MPI_Comm             comm;
    dealii::ConditionalOStream out;
    dealii::TimerOutput        timer;
    dealii::Timer              clock; ///< since the start

    std::unique_ptr<Mesh<dim>>              mesh;
    std::unique_ptr<Elasticity<dim>>        elasticity;
    std::unique_ptr<ContactInterfaces<dim>> contact;
    State                                   state;
    std::unique_ptr<Equilibrium<dim>>       equilibrium;
    std::unique_ptr<Recorder<dim>>          recorder; ///< none where nothing is to be written
    bool                                    only_checks = false;
    unsigned int                            n_steps = 0; ///< of Newton's method on a coarse mesh
    ErrorControl                            control;     ///< of the end of the load history
    double                                  tolerance;   ///< of Newton's method on the next mesh
    /// The number of the mesh on which the end was judged last, unless one was made for it since.
    std::optional<unsigned int> end_judged_on;
    double                      last_mesh_at = 0; ///< seconds: when it was estimated
    std::vector<unsigned int>   next_quadratic;   ///< bodies, on the next mesh
    /// The largest share, where Deformation = automatic.
    std::optional<double> neglected_work;
    std::string           reason_targets_missed; ///< the targets; empty: no reason is known
    Json                  of_step;            ///< how good the last load step is; null: not known
    unsigned int          former_cycles  = 0; ///< of multigrid on this mesh, before a restart
    double                former_seconds = 0; ///< likewise

    /// What a checkpoint needs beside the results: copies, since attempts change the originals.
    struct CheckpointState
    {
      State state;
      Json  head; ///< the same on all ranks
    };
    const bool                          is_restart;
    bool                                is_interrupted = false;
    bool                                is_restored    = false; ///< and nothing was solved since
    bool                                has_progressed = false; ///< something, since the start
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
