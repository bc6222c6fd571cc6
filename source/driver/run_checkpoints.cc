// SPDX-License-Identifier: Apache-2.0
#include "driver/run_checkpoints.h"

#include "checkpoint/cells.h"
#include "checkpoint/origin.h"
#include "output/accuracy_results.h"
#include <signorini/base/scene_error.h>
#include <signorini/base/text.h>

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



  // The first rank reads or writes the scene, and broadcasts its checksum.
  template <int dim>
  RunCheckpoints<dim>::RunCheckpoints(const RunOrigin          origin,
                                      Problem<dim>            &problem,
                                      AdaptiveRefinement<dim> &refinement,
                                      Recorder<dim>           &recorder,
                                      Position                &position,
                                      const Timer             &clock,
                                      TimerOutput             &timer,
                                      const MPI_Comm           comm,
                                      ConditionalOStream      &out)
    : run_origin(origin)
    , problem(problem)
    , refinement(refinement)
    , recorder(recorder)
    , position(position)
    , clock(clock)
    , timer(timer)
    , comm(comm)
    , out(out)
    , checkpoints(recorder.directory(), comm)
  {
    if (run_origin == RunOrigin::program)
      return;
    if (Utilities::MPI::this_mpi_process(comm) == 0)
      {
        // A new run stores its scene with all defaults, from which restarts read it.
        if (run_origin == RunOrigin::scene_file)
          write_origin(recorder.directory(),
                       origin_of(problem.decisions.scene.name,
                                 text_with_defaults(problem.decisions)));
        scene_checksum = checksum_of_origin(recorder.directory());
      }
    scene_checksum = Utilities::MPI::broadcast(comm, scene_checksum);
    if (run_origin == RunOrigin::checkpoint)
      find_former();
    if (run_origin != RunOrigin::checkpoint || !former)
      return;
    if (const auto end = end_of_finished_run(recorder.directory()))
      add_load_steps(*end);
  }



  template <int dim>
  void
  RunCheckpoints<dim>::find_former()
  {
    former = checkpoints.newest(out);
    if (!former)
      {
        out << "There is no checkpoint yet: the run starts from the beginning." << std::endl;
        recorder.restore({});
        return;
      }
    const Json         &head   = former->head;
    const std::uint32_t of_run = head.at("origin");
    if (of_run != scene_checksum && of_run != read_origin(recorder.directory()).continues)
      throw SceneError(
        "--restart " + recorder.directory() + ": " + former->name +
        " and restart.scene belong to different runs; solve the scene from the start");
    const Json &path = head.at("path");
    position         = {head.at("cycle"),
                        head.at("time"),
                        head.at("step"),
                        head.at("longest"),
                        {{path.at(0), path.at(1)}, {path.at(2), path.at(3)}}};
    out << "Restart from " << recorder.directory() << "/" << former->name << ", written by "
        << head.at("parts").size() << " ranks: mesh " << position.cycle << ", load step "
        << position.step << ", t = " << position.time << std::endl;
  }



  template <int dim>
  void
  RunCheckpoints<dim>::restore_decisions()
  {
    problem.decisions.load(former->head.at("decisions"));
    if (const double share = former->head.value("neglected_work", -1.); share >= 0)
      problem.neglected_work = share;
  }



  template <int dim>
  void
  RunCheckpoints<dim>::restore_mesh()
  {
    restore_cells(*problem.mesh, joined(former->parts).displacement);
    check_mark(*problem.mesh, former->head.at("mesh"));
  }



  template <int dim>
  void
  RunCheckpoints<dim>::restore_state()
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
    there.displacement   = displacement(part.displacement, "rigid_motion");
    there.contact        = field_of(part.contact, dim);
    there.time           = head.at("state_time");
    there.friction_work  = head.at("friction_work").get<std::vector<double>>();
    there.friction_bound = head.at("friction_bound").get<std::vector<double>>();
    // Only runs whose solution depends on the path have a start of the load step.
    if (head.contains("rigid_motion_at_start"))
      there.start = {displacement(part.start_displacement, "rigid_motion_at_start"),
                     field_of(part.start_contact, dim),
                     part.start_material,
                     head.at("duration"),
                     head.at("friction_work_at_start"),
                     head.at("friction_bound_at_start")};
    there.material = part.material;
    problem.equilibrium->set_state(there, head.at("follows"));
    problem.former_cycles  = head.at("multigrid_cycles");
    problem.former_seconds = head.at("mesh_seconds");
    recorder.restore(head.at("results"));
    for (const Json &cycle : recorder.cycles())
      if (!cycle.at("accuracy").contains("time")) // of the end of the load history
        refinement.control.add(quantities_of(cycle.at("accuracy")));
    refinement.tolerance  = head.at("tolerance");
    refinement.path_parts = head.value("path_parts", 1u);
    if (adds_load_steps)
      check_past();
    former.reset();
    my_is_restored = true;
  }



  template <int dim>
  void
  RunCheckpoints<dim>::pass(const bool is_finished)
  {
    if (run_origin == RunOrigin::program)
      return;
    Json head = {{"cycle", position.cycle},
                 {"time", position.time},
                 {"step", position.step},
                 {"longest", position.longest},
                 {"path",
                  {position.path.largest.tractions,
                   position.path.largest.work,
                   position.path.spent.tractions,
                   position.path.spent.work}},
                 {"state_time", problem.state.time},
                 {"friction_work", problem.state.friction_work},
                 {"friction_bound", problem.state.friction_bound},
                 {"follows", problem.equilibrium->uses_current_geometry()},
                 {"tolerance", refinement.tolerance},
                 {"path_parts", refinement.path_parts},
                 {"decisions", problem.decisions.save()},
                 {"neglected_work", problem.neglected_work.value_or(-1)},
                 {"multigrid_cycles", problem.multigrid_cycles()},
                 {"rigid_motion", problem.elasticity->rigid_motion(problem.state.displacement)},
                 {"pairs", problem.contact->save()}};
    if (problem.state.start.displacement.size() > 0)
      {
        head["rigid_motion_at_start"] =
          problem.elasticity->rigid_motion(problem.state.start.displacement);
        head["duration"]                = problem.state.start.duration;
        head["friction_work_at_start"]  = problem.state.start.friction_work;
        head["friction_bound_at_start"] = problem.state.start.friction_bound;
      }
    last = Passed{problem.state, head};
    if (position.cycle + position.step == 0 || std::exchange(my_is_restored, false) ||
        (is_finished && !problem.decisions.scene.output.keep_checkpoint))
      // Nothing has been solved that a restart would lose.
      return;

    my_has_progressed = true;
    ++steps_since;
    const OutputSettings<dim> &settings = problem.decisions.scene.output;
    const double               passed   = clock.wall_time() - written_at;
    const bool                 is_due =
      (settings.checkpoint_steps > 0 &&
       (steps_since >= settings.checkpoint_steps || position.step == 0)) ||
      (settings.checkpoint_minutes > 0 && passed >= 60 * settings.checkpoint_minutes);
    if (Utilities::MPI::max(int(is_due), comm))
      write();
  }



  template <int dim>
  void
  RunCheckpoints<dim>::write()
  {
    TimerOutput::Scope scope(timer, "checkpoint");
    Json               head = last->head;
    head["origin"]          = scene_checksum;
    head["mesh_seconds"]    = problem.mesh_seconds();
    head["mesh"]            = mark_of_mesh(*problem.mesh);
    head["results"]         = recorder.save();
    const State &now        = last->state;
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
    if (checkpoints.write(head, {bytes.begin(), bytes.end()}))
      out << "  checkpoint after load step " << head["step"] << ": "
          << megabytes(checkpoints.bytes()) << " in " << short_text(checkpoints.seconds(), 2)
          << " s" << std::endl;
    else
      out
        << "  WARNING: the checkpoint cannot be written; is the disk full? The previous one is kept, "
        << "and the run goes on" << std::endl;
    written_at  = clock.wall_time();
    steps_since = 0;
  }



  template <int dim>
  void
  RunCheckpoints<dim>::write_last()
  {
    if (last && steps_since > 0)
      write();
  }



  template class RunCheckpoints<2>;
  template class RunCheckpoints<3>;
} // namespace Signorini
