// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "checkpoint/checkpoints.h"
#include "driver/adaptive_refinement.h"
#include "driver/path_control.h"
#include "output/recorder.h"
#include <signorini/base/exit_code.h>

#include <limits>
#include <optional>

namespace Signorini
{
  /// What a run starts from, which decides whether it can be restarted.
  enum class RunOrigin
  {
    scene_file, ///< a scene, which is stored for restarts
    checkpoint, ///< the output directory of a run that is continued
    /// The scene of a program that links the library. It may contain obstacles, meshes and laws of
    /// classes that no scene file can name. A restart would read others in their place, therefore
    /// no checkpoints are written.
    program
  };

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
    /// With friction; largest sizes of zero: unknown.
    PathControl::Budget path;
  };

  /// @return the end of the load history of the run in an output directory, if that run is
  /// finished. A finished run has complete results; any other content of the file counts as
  /// unfinished. A run to which load steps were added of which none was solved is still finished at
  /// its former end.
  /// @param directory of the run
  std::optional<double>
  end_of_finished_run(const std::string &directory);

  /// @return the exit code of the run in the output directory of a scene, if that run is finished
  /// and the scene has no load steps beyond. Checkpoints that it has left, because it was killed
  /// after its last results, are removed. Throws SceneError if there are further load steps, but no
  /// checkpoint. Collective.
  template <int dim>
  std::optional<ExitCode>
  exit_code_of_finished_run(const Scene<dim> &scene, MPI_Comm comm);

  /// The checkpoints of one run: reads that from which the run is continued, and writes those from
  /// which it can be. All functions are collective unless they only return a value.
  template <int dim>
  class RunCheckpoints
  {
  public:
    /// Identify the newest valid checkpoint of a run that is continued, and set `position` to it;
    /// store the scene of another run. Throws SceneError if checkpoint and scene are of different
    /// runs. Keeps references to its arguments.
    /// @param clock of the run
    RunCheckpoints(RunOrigin                   origin,
                   Problem<dim>               &problem,
                   AdaptiveRefinement<dim>    &refinement,
                   Recorder<dim>              &recorder,
                   Position                   &position,
                   const dealii::Timer        &clock,
                   dealii::TimerOutput        &timer,
                   MPI_Comm                    comm,
                   dealii::ConditionalOStream &out);

    // Restart, in the order in which the parts of a problem are made:

    /// True if there is a checkpoint that was not restored yet.
    bool
    has_former() const
    {
      return former.has_value();
    }

    /// The decisions of the former run replace those that would be made anew, so that both parts of
    /// a run are the same simulation.
    void
    restore_decisions();

    /// Refine the coarse mesh until it has the cells of the checkpoint, and compare it with the
    /// stored mark.
    void
    restore_mesh();

    /// Restore displacement, surface fields, internal variables, error history and counters, on the
    /// mesh that was restored before.
    void
    restore_state();

    /// True from a restart until something is solved.
    bool
    is_restored() const
    {
      return my_is_restored;
    }

    // Writing:

    /// Remember the state between two load steps or meshes as one from which a restart can
    /// continue, and write it if the interval has passed.
    /// @param is_finished nothing is left to be solved
    void
    pass(bool is_finished);

    /// Forget the last state that was passed: it belongs to a mesh that was changed.
    void
    forget()
    {
      last.reset();
    }

    /// Write the last state that was passed once more, for a run that ends without a solution,
    /// unless it is on the disk already.
    void
    write_last();

    /// Remove all checkpoints. The results must say before that the run is complete.
    void
    remove()
    {
      checkpoints.remove();
    }

    /// True if a restart would continue behind the start of this process.
    bool
    has_progressed() const
    {
      return my_has_progressed;
    }

    /// The time to be reserved before time limits for writing a checkpoint [s].
    double
    reserve() const
    {
      return 2 * checkpoints.seconds() + 1;
    }

  private:
    /// Find the checkpoint of a restart, and compare it with the stored scene.
    void
    find_former();
    /// Store the scene of further load steps after a finished run. @param end of that run
    void
    add_load_steps(double end);
    /// Throws SceneError where the scene of further load steps contradicts the state at which they
    /// begin. Collective.
    void
    check_past() const;
    /// Write a checkpoint of the last state. If the disk is full the previous one is kept.
    void
    write();

    const RunOrigin             run_origin;
    Problem<dim>               &problem;
    AdaptiveRefinement<dim>    &refinement;
    Recorder<dim>              &recorder;
    Position                   &position;
    const dealii::Timer        &clock;
    dealii::TimerOutput        &timer;
    const MPI_Comm              comm;
    dealii::ConditionalOStream &out;

    Checkpoints                         checkpoints;
    std::uint32_t                       scene_checksum = 0; ///< checksum_of_origin()
    std::optional<Checkpoints::Content> former;             ///< until it is restored

    /// The state of a checkpoint, without the results: a copy, since attempts to solve change the
    /// original.
    struct Passed
    {
      State state;
      Json  head; ///< the same on all ranks
    };
    std::optional<Passed> last;
    bool                  adds_load_steps   = false;
    bool                  my_is_restored    = false;
    bool                  my_has_progressed = false;
    double                written_at        = 0; ///< seconds: the last checkpoint
    unsigned int          steps_since       = 0; ///< states passed since then
  };
} // namespace Signorini
