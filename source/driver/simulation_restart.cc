// SPDX-License-Identifier: Apache-2.0
#include "checkpoint/cells.h"
#include "checkpoint/origin.h"
#include "driver/simulation.h"
#include "output/accuracy_results.h"
#include <signorini/base/scene_error.h>
#include <signorini/base/text.h>

#include <fstream>
#include <utility>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    using Places = std::vector<std::pair<FaceId, std::vector<SurfacePointValue>>>;

    /// The part of a checkpoint that each rank writes for itself: the state, and the start of its
    /// load step if the solution depends on the path. Values are stored by cell or by face and
    /// position, so that another number of ranks can read them.
    struct Part
    {
      std::vector<CellValues> displacement, start_displacement;
      Places                  contact, start_contact;
      CellVariables           material, start_material;

      template <class Archive>
      void
      serialize(Archive &ar, const unsigned int)
      {
        ar &displacement &contact &material &start_displacement &start_contact &start_material;
      }
    };

    /// Append a vector to another.
    template <typename T>
    void
    append(const std::vector<T> &from, std::vector<T> &to)
    {
      to.insert(to.end(), from.begin(), from.end());
    }

    /// The values of a surface field, as a list of faces.
    Places
    places_of(const SurfaceField &field)
    {
      return {field.values().begin(), field.values().end()};
    }

    /// A surface field from a list of faces.
    SurfaceField
    field_of(const Places &places, const unsigned int dim)
    {
      SurfaceField result(dim);
      for (const auto &[face, values] : places)
        result.set(face, values);
      return result;
    }

    /// The union of the parts that ranks have written; of a restart with other partition each rank
    /// reads all of them.
    Part
    joined(const std::vector<std::string> &texts)
    {
      Part result;
      for (const std::string &text : texts)
        {
          const std::vector<char> bytes(text.begin(), text.end());
          const Part              part = Utilities::unpack<Part>(bytes, false);
          append(part.displacement, result.displacement);
          append(part.contact, result.contact);
          append(part.start_displacement, result.start_displacement);
          append(part.start_contact, result.start_contact);
          result.material.insert(part.material.begin(), part.material.end());
          result.start_material.insert(part.start_material.begin(), part.start_material.end());
        }
      return result;
    }

    /// A size for messages.
    std::string
    megabytes(const double bytes)
    {
      return short_text(bytes / 1e6, 3) + " MB";
    }
  } // namespace



  // A finished run has complete results; any other content of the file counts as unfinished.
  template <int dim>
  std::optional<ExitCode>
  Simulation<dim>::code_of_finished_run() const
  {
    std::ifstream file(scene.output.directory + "/results.json");
    const Json    results = Json::parse(file, nullptr, false);
    if (!results.is_object() || !results.value("complete", false))
      return {};
    const int code = results.at("exit_code");
    out << "The run in " << scene.output.directory << " is finished, with exit code " << code
        << ": nothing was done." << std::endl;
    return static_cast<ExitCode>(code);
  }



  // Identify the newest valid checkpoint, and check that it belongs to the same scene as the stored
  // origin. The first rank reads and broadcasts the checksum. Collective.
  template <int dim>
  void
  Simulation<dim>::find_checkpoint()
  {
    checkpoints = std::make_unique<Checkpoints>(recorder->directory(), comm);
    if (Utilities::MPI::this_mpi_process(comm) == 0)
      {
        // A new run stores its scene with all defaults, from which restarts read it.
        if (!is_restart)
          write_origin(recorder->directory(),
                       origin_of(scene.name, text_with_defaults(problem.decisions)));
        origin = checksum_of_origin(recorder->directory());
      }
    origin = Utilities::MPI::broadcast(comm, origin);
    if (!is_restart)
      return;
    former = checkpoints->newest(out);
    if (!former)
      {
        out << "There is no checkpoint yet: the run starts from the beginning." << std::endl;
        recorder->restore({});
        return;
      }
    const Json &head = former->head;
    if (head.at("origin") != origin)
      throw SceneError(
        "--restart " + recorder->directory() + ": " + former->name +
        " and restart.scene belong to different runs; solve the scene from the start");
    position = {head.at("cycle"), head.at("time"), head.at("step"), head.at("longest")};
    out << "Restart from " << recorder->directory() << "/" << former->name << ", written by "
        << head.at("parts").size() << " ranks: mesh " << position.cycle << ", load step "
        << position.step << ", t = " << position.time << std::endl;
  }



  // The choices of the former run replace those that would be made anew, so that both parts of a
  // run are the same simulation.
  template <int dim>
  void
  Simulation<dim>::restore_decisions()
  {
    problem.decisions.load(former->head.at("decisions"));
    if (const double share = former->head.value("neglected_work", -1.); share >= 0)
      problem.neglected_work = share;
  }



  // Refine the coarse mesh until it has the cells of the checkpoint, and compare it with the stored
  // mark. Collective.
  template <int dim>
  void
  Simulation<dim>::restore_mesh()
  {
    restore_cells(*problem.mesh, joined(former->parts).displacement);
    check_mark(*problem.mesh, former->head.at("mesh"));
  }



  // Displacement, surface fields, internal variables, error history and counters of the checkpoint,
  // on the mesh that was restored before. Collective.
  template <int dim>
  void
  Simulation<dim>::restore_state()
  {
    const Json &head = former->head;
    const Part  part = joined(former->parts);
    problem.contact->load(head.at("pairs"));
    const auto displacement = [&](const std::vector<CellValues> &cells, const char *rigid_motion) {
      const std::vector<double> rigid  = head.at(rigid_motion);
      LA::Vector                result = vector_of_cells(*problem.elasticity, cells);
      problem.elasticity->set_rigid_motion(rigid, result);
      return result;
    };
    State there;
    there.displacement = displacement(part.displacement, "rigid_motion");
    there.contact      = field_of(part.contact, dim);
    there.time         = head.at("state_time");
    // Only runs whose solution depends on the path have a start of the load step.
    if (head.contains("rigid_motion_at_start"))
      there.start = {displacement(part.start_displacement, "rigid_motion_at_start"),
                     field_of(part.start_contact, dim),
                     part.start_material,
                     head.at("duration")};
    there.material = part.material;
    problem.equilibrium->set_state(there, head.at("follows"));
    problem.former_cycles  = head.at("multigrid_cycles");
    problem.former_seconds = head.at("mesh_seconds");
    recorder->restore(head.at("results"));
    for (const Json &cycle : recorder->cycles())
      if (!cycle.at("accuracy").contains("time")) // of the end of the load history
        refinement.control.add(quantities_of(cycle.at("accuracy")));
    refinement.tolerance = head.at("tolerance");
    former.reset();
    is_restored = true;
  }



  template <int dim>
  bool
  Simulation<dim>::is_finished() const
  {
    return position.time >= scene.load_steps.ends().back();
  }



  // Remember the state between two load steps or meshes as one from which a restart can continue,
  // and write it if the interval has passed. Attempts to solve change the original, therefore it is
  // copied. Collective.
  template <int dim>
  void
  Simulation<dim>::pass_checkpoint()
  {
    Json head = {{"cycle", position.cycle},
                 {"time", position.time},
                 {"step", position.step},
                 {"longest", position.longest},
                 {"state_time", problem.state.time},
                 {"follows", problem.equilibrium->uses_current_geometry()},
                 {"tolerance", refinement.tolerance},
                 {"decisions", problem.decisions.save()},
                 {"neglected_work", problem.neglected_work.value_or(-1)},
                 {"multigrid_cycles", problem.multigrid_cycles()},
                 {"rigid_motion", problem.elasticity->rigid_motion(problem.state.displacement)},
                 {"pairs", problem.contact->save()}};
    if (problem.state.start.displacement.size() > 0)
      {
        head["rigid_motion_at_start"] =
          problem.elasticity->rigid_motion(problem.state.start.displacement);
        head["duration"] = problem.state.start.duration;
      }
    checkpoint_state = CheckpointState{problem.state, head};
    if (position.cycle + position.step == 0 || std::exchange(is_restored, false) || is_finished())
      // Nothing has been solved that a restart would lose.
      return;

    has_progressed = true;
    ++steps_since;
    const OutputSettings<dim> &settings = scene.output;
    const double               passed   = clock.wall_time() - written_at;
    const bool                 is_due =
      (settings.checkpoint_steps > 0 &&
       (steps_since >= settings.checkpoint_steps || position.step == 0)) ||
      (settings.checkpoint_minutes > 0 && passed >= 60 * settings.checkpoint_minutes);
    if (Utilities::MPI::max(int(is_due), comm))
      write_checkpoint();
  }



  // If the disk is full the previous checkpoint is kept. The time of writing is reserved before
  // time limits. Collective.
  template <int dim>
  void
  Simulation<dim>::write_checkpoint()
  {
    TimerOutput::Scope scope(timer, "checkpoint");
    Json               head = checkpoint_state->head;
    head["origin"]          = origin;
    head["mesh_seconds"]    = problem.mesh_seconds();
    head["mesh"]            = mark_of_mesh(*problem.mesh);
    head["results"]         = recorder->save();
    const State &now        = checkpoint_state->state;
    Part         part;
    part.displacement = values_of_cells(*problem.elasticity, now.displacement);
    part.contact      = places_of(now.contact);
    part.material     = now.material;
    if (now.start.displacement.size() > 0)
      {
        part.start_displacement = values_of_cells(*problem.elasticity, now.start.displacement);
        part.start_contact      = places_of(now.start.contact);
        part.start_material     = now.start.material;
      }
    const std::vector<char> bytes = Utilities::pack(part, false);
    if (checkpoints->write(head, {bytes.begin(), bytes.end()}))
      out << "  checkpoint after load step " << head["step"] << ": "
          << megabytes(checkpoints->bytes()) << " in " << short_text(checkpoints->seconds(), 2)
          << " s" << std::endl;
    else
      out
        << "  WARNING: the checkpoint cannot be written; is the disk full? The previous one is kept, "
        << "and the run goes on" << std::endl;
    if (interruption)
      interruption->set_reserve(2 * checkpoints->seconds() + 1);
    written_at  = clock.wall_time();
    steps_since = 0;
  }



  // The last state that is known to be good is written once more at the end of a run that failed or
  // was interrupted, unless it is on the disk already.
  template <int dim>
  void
  Simulation<dim>::write_final_checkpoint()
  {
    if (checkpoint_state && steps_since > 0)
      write_checkpoint();
  }



  template <int dim>
  StepVisitor
  Simulation<dim>::watch()
  {
    const StepVisitor print = print_steps(out);
    return [this, print](const NewtonStep &step) {
      print(step);
      check_for_interruption();
    };
  }



#define INSTANTIATE(dim)                                                                           \
  template std::optional<ExitCode> Simulation<dim>::code_of_finished_run() const;                  \
  template bool                    Simulation<dim>::is_finished() const;                           \
  template void                    Simulation<dim>::find_checkpoint();                             \
  template void                    Simulation<dim>::restore_decisions();                           \
  template void                    Simulation<dim>::restore_mesh();                                \
  template void                    Simulation<dim>::restore_state();                               \
  template void                    Simulation<dim>::pass_checkpoint();                             \
  template void                    Simulation<dim>::write_checkpoint();                            \
  template void                    Simulation<dim>::write_final_checkpoint();                      \
  template StepVisitor             Simulation<dim>::watch();
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
