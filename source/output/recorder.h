// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "accuracy/error_control.h"
#include "output/directory.h"
#include "output/files.h"
#include "output/results.h"
#include "scene/decisions.h"
#include "solver/linear_reference.h"
#include "solver/newton_report.h"
#include "verdict/verdict.h"
#include <signorini/base/exit_code.h>

#include <deal.II/base/timer.h>

#include <optional>

namespace Signorini
{
  /// @return the entries of results.json about pairs, forces, probes and errors of a solution.
  /// Collective.
  /// @param scene the scene
  /// @param now the solution
  /// @param probes of the scene
  template <int dim>
  Json
  results_at(const Scene<dim>              &scene,
             const Snapshot<dim>           &now,
             const std::vector<Probe<dim>> &probes);

  /// @return the scene with all defaults, as it is written to the output directory; it can be run
  /// again.
  /// @param decisions the scene with all choices
  template <int dim>
  std::string
  text_with_defaults(const Decisions<dim> &decisions);

  /// Records the results of a run: results.json, which grows from step to step and is marked as
  /// unfinished until the end, so that a run that is killed leaves what it had computed; the files
  /// of Writer; and scene.prm. doc/guide/results.md describes all of them. Refers to its arguments.
  template <int dim>
  class Recorder
  {
  public:
    /// Lock the output directory. Throws SceneError if that is impossible. Collective.
    /// @param decisions the scene with all choices
    /// @param clock of the whole run
    /// @param timer of its parts
    /// @param comm the ranks
    /// @param is_restart whether existing files are kept, and nothing is written before restore()
    /// @param remark a comment at the top of scene.prm, without line end; empty: none
    Recorder(const Decisions<dim>      &decisions,
             const dealii::Timer       &clock,
             const dealii::TimerOutput &timer,
             MPI_Comm                   comm,
             bool                       is_restart = false,
             const std::string         &remark     = "");

    /// Continue with the results of an earlier process, and remove files that it has written later.
    /// Collective.
    /// @param former results of save(); empty: from the beginning
    void
    restore(const Json &former);

    /// @return the results that restore() needs. Collective.
    const Json &
    save();

    /// Write scene.prm, the scene with all defaults. Throws OutputError.
    /// @param remark a comment at its top; empty: none
    void
    write_scene(const std::string &remark) const;

    /// @return the path of the output directory.
    const std::string &
    directory() const
    {
      return path;
    }

    /// @return OutputDirectory::note().
    const std::string &
    note() const
    {
      return folder.note();
    }

    // During the run; collective except for the first two:

    /// Record the report of preflight().
    void
    add_preflight(const Json &report);
    /// Record the configuration in which contact is evaluated.
    /// @param change estimated relative change of the pressure by a geometry update; none: not
    /// estimated
    /// @param updated whether contact is evaluated in the current configuration
    void
    add_contact_geometry(std::optional<double> change, bool updated);
    /// Record the kinematics.
    /// @param neglected share of the work that small strain neglects, (6.21) of doc/theory; none:
    /// not estimated
    /// @param finite whether strain is finite from now on
    void
    add_deformation(std::optional<double> neglected, bool finite);
    /// Record by how much halving the load step has changed tangential tractions, relative to the
    /// largest ones, if that was done. The sum of all load steps is reported.
    /// @param time of the load step
    void
    add_path_error(std::optional<double> change, double time);
    /// Check that the load step follows the loads.
    /// @param deviation see Equilibrium::deviation_of_loads(); @param time of the load step
    void
    add_deviation_of_loads(double deviation, double time);
    /// Record the solution on a mesh that will be refined.
    /// @param newton_iterations of this solution
    /// @param multigrid_cycles of this solution
    /// @param accuracy its error estimates
    void
    add_cycle(unsigned int newton_iterations, unsigned int multigrid_cycles, const Json &accuracy);
    /// Record the errors of the last load step.
    /// @param accuracy entry of accuracy_results()
    /// @param control the histories of errors
    /// @param why reason why targets were not reached; empty: they were, or there are none
    /// @param lacks_former_steps whether the bounds lack errors that former load steps have left
    void
    add_accuracy(const Json         &accuracy,
                 const ErrorControl &control,
                 const std::string  &why,
                 bool                lacks_former_steps);
    /// Record how the targets were met at a load step.
    /// @param control the histories of errors
    /// @param why reason why targets were not reached; empty: they were
    /// @param time of the load step
    void
    add_targets(const ErrorControl &control, const std::string &why, double time);
    /// @return the entries of the load steps so far.
    const Json &
    load_steps() const
    {
      return results["load_steps"];
    }
    /// @return the entries of all meshes that have been refined.
    const Json &
    cycles() const
    {
      return results["cycles"];
    }
    /// Record a load step: add its checks to the verdict, and write its files. Collective.
    /// @param now the solution
    /// @param report of Newton's method
    /// @param multigrid_cycles of the linear solver so far
    /// @param accuracy error estimates; null: the load step has none
    void
    add_step(const Snapshot<dim> &now,
             const NewtonReport  &report,
             unsigned int         multigrid_cycles,
             const Json          &accuracy);
    /// Record the comparison with a linear problem without contact.
    /// @param linear its costs
    /// @param seconds of the solution with contact
    /// @param cycles of multigrid of the solution with contact
    void
    add_linear_reference(const LinearReference &linear, double seconds, double cycles);
    /// Record the sizes of the model; called again when they change. Collective.
    /// @param elasticity the model
    /// @param surfaces contact surfaces of all pairs
    /// @param contact the gap operator
    /// @param skipped_items what was omitted
    void
    add_sizes(const Elasticity<dim>                  &elasticity,
              const std::vector<ContactSurface<dim>> &surfaces,
              const GapOperator                      &contact,
              const std::vector<std::string>         &skipped_items);

    /// Record a load step that was not solved, with its last iterate, whose status is 2 at contact
    /// points that alternate. Collective.
    /// @param now the last iterate
    /// @param report of Newton's method
    void
    add_failure(const Snapshot<dim> &now, const NewtonReport &report);

    /// Complete the results at the end of the run, and compare a converged solution with what the
    /// scene expects. Collective.
    /// @param report of Newton's method at the last load step
    /// @param text receives the summary
    /// @param is_interrupted whether the run was interrupted from outside
    /// @return the exit code of the program
    ExitCode
    finish(const NewtonReport &report, std::ostream &text, bool is_interrupted = false);

    /// Record that the run ends with an error. Not collective.
    /// @param why the error
    void
    stop(const std::string &why);


  private:
    void
    begin();
    void
    add_costs();
    Json
    newton_results(const NewtonReport &report) const;
    void
    write();

    const Decisions<dim>      &decisions;
    const Scene<dim>          &scene;
    const dealii::Timer       &clock;
    const dealii::TimerOutput &timer;
    const MPI_Comm             comm;
    const std::string          path;
    OutputDirectory            folder;
    Writer<dim>                writer;
    Json                       results;
    Verdict                    verdict;
    /// Times of earlier processes of this run.
    Json seconds_before;
    /// Largest force of all load steps so far.
    double largest_force = 0;
    /// When results.json was last written [s since the start], and how long that took [s].
    double written_at = 0, writing_takes = 0;
  };
} // namespace Signorini
