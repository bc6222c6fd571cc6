// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "accuracy/error_control.h"
#include "output/directory.h"
#include "output/probe_results.h"
#include "output/results.h"
#include "output/writer.h"
#include "scene/decisions.h"
#include "solver/linear_reference.h"
#include "solver/newton_report.h"
#include "verdict/verdict.h"
#include <signorini/base/exit_code.h>

#include <deal.II/base/timer.h>

#include <optional>

namespace Signorini
{
  /// What results.json says of the pairs, forces, probes and errors of a solution. Collective.
  template <int dim>
  Json
  results_at(const Scene<dim>              &scene,
             const Snapshot<dim>           &now,
             const std::vector<Probe<dim>> &probes);

  /// The scene as it is left in the output directory, runnable again.
  template <int dim>
  std::string
  text_with_defaults(const Decisions<dim> &decisions);

  /// What a run leaves behind: results.json, which grows from step to step and says `unfinished`
  /// until the end, so that a run that is killed leaves what it had; the files of Writer; and
  /// scene.prm. doc/guide/results.md describes all of it. Keeps references to its arguments.
  template <int dim>
  class Recorder
  {
  public:
    /// Takes the output directory. Throws SceneError if that cannot be had. Collective.
    /// @param is_restart what is there stays, and nothing is written before restore()
    Recorder(const Decisions<dim>      &decisions,
             const dealii::Timer       &clock,
             const dealii::TimerOutput &timer,
             MPI_Comm                   comm,
             bool                       is_restart = false);

    /// Goes on with the results of an earlier process, and drops what that one wrote later. Empty:
    /// from the beginning. Collective.
    void
    restore(const Json &former);

    /// What restore() needs. Collective.
    const Json &
    save();

    const std::string &
    directory() const
    {
      return path;
    }

    /// See OutputDirectory::note().
    const std::string &
    note() const
    {
      return folder.note();
    }

    // As the run goes on; collective but for the first two:

    void
    add_preflight(const Json &report);
    /// @param change of the pressure by an update, relative; empty: not estimated
    /// @param updated contact is on the surfaces as they are now
    void
    add_contact_geometry(std::optional<double> change, bool updated);
    /// @param neglected share of the work that small strain neglects; empty: not estimated
    /// @param finite the deformation is large from now on
    void
    add_deformation(std::optional<double> neglected, bool finite);
    /// A solution on a mesh that is refined then.
    void
    add_cycle(unsigned int newton_iterations, unsigned int multigrid_cycles, const Json &accuracy);
    /// The errors of the last load step. @param why the targets were not reached; empty: they were,
    /// or there are none
    void
    add_accuracy(const Json &accuracy, const ErrorControl &control, const std::string &why);
    /// How good the targets were met at a load step. @param why they were not; empty: they were
    void
    add_targets(const ErrorControl &control, const std::string &why, double time);
    /// The results on all meshes that were refined so far.
    const Json &
    cycles() const
    {
      return results["cycles"];
    }
    /// @param multigrid_cycles of the linear solver so far
    /// @param accuracy of the wanted quantities; null: the load step was not judged
    void
    add_step(const Snapshot<dim> &now,
             const NewtonReport  &report,
             unsigned int         multigrid_cycles,
             const Json          &accuracy);
    /// @param seconds and cycles of the solution with contact
    void
    add_linear_reference(const LinearReference &linear, double seconds, double cycles);
    /// What the scene has become; called again when that changes.
    void
    add_sizes(const Elasticity<dim>                  &elasticity,
              const std::vector<ContactSurface<dim>> &surfaces,
              const GapOperator                      &contact,
              const std::vector<std::string>         &skipped_items);

    /// The load step that was not solved: its last iterate, where `active` is 2 at contact points
    /// that change to and fro. Collective.
    void
    add_failure(const Snapshot<dim> &now, const NewtonReport &report);

    /// The end. A run that has converged is compared with what the scene expects. @param text gets
    /// the summary for a person. Collective.
    /// @param is_interrupted from outside
    ExitCode
    finish(const NewtonReport &report, std::ostream &text, bool is_interrupted = false);

    /// The end of a run that ends with an error. Not collective.
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
    Json                       seconds_before;    ///< of processes before this one
    double                     largest_force = 0; ///< of all load steps so far
    double written_at = 0, writing_takes = 0;     ///< seconds: the file grows from step to step
  };
} // namespace Signorini
