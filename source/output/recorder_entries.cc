// SPDX-License-Identifier: Apache-2.0
#include "output/recorder.h"
#include "verdict/checks.h"

#include <algorithm>

// The functions of the recorder that add entries to the results during the run.

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  void
  Recorder<dim>::add_preflight(const Json &report)
  {
    results["preflight"] = report;
  }



  template <int dim>
  void
  Recorder<dim>::add_contact_geometry(const std::optional<double> change, const bool updated)
  {
    Json &geometry      = results["contact_geometry"];
    geometry["updated"] = updated;
    if (change)
      geometry["change_of_pressure"] = *change;
  }



  template <int dim>
  void
  Recorder<dim>::add_deformation(const std::optional<double> neglected, const bool finite)
  {
    Json &deformation     = results["deformation"];
    deformation["finite"] = finite;
    if (neglected)
      deformation["neglected_work"] = *neglected;
  }



  template <int dim>
  void
  Recorder<dim>::add_path_error(const std::optional<double> change, const double time)
  {
    if (!change)
      return;
    const double sum      = results.value("path_error", 0.) + *change;
    results["path_error"] = sum;
    verdict.add(check_path_error(sum, scene.load_steps.path_error), time);
  }



  template <int dim>
  void
  Recorder<dim>::add_deviation_of_loads(const double deviation, const double time)
  {
    verdict.add(check_deviation_of_loads(deviation), time);
  }



  template <int dim>
  void
  Recorder<dim>::add_cycle(const unsigned int newton_iterations,
                           const unsigned int multigrid_cycles,
                           const Json        &accuracy)
  {
    results["cycles"].push_back({{"newton_iterations", newton_iterations},
                                 {"multigrid_cycles", multigrid_cycles},
                                 {"dofs", results["dofs"]},
                                 {"seconds", clock.wall_time()},
                                 {"accuracy", accuracy}});
  }



  // The errors of the last load step are reported at the top level as well.
  template <int dim>
  void
  Recorder<dim>::add_accuracy(const Json         &accuracy,
                              const ErrorControl &control,
                              const std::string  &why,
                              const bool          lacks_former_steps)
  {
    const double end    = scene.load_steps.ends().back();
    results["accuracy"] = accuracy;
    verdict.add(check_former_steps(lacks_former_steps), end);
    verdict.add(check_limits(scene.goals, control), end);
    if (scene.goals.has_targets())
      {
        results["accuracy"]["met"]    = why.empty();
        results["accuracy"]["reason"] = why;
        add_targets(control, why, end);
      }
    results["load_steps"].back()["accuracy"] = results["accuracy"];
    // Load steps with the entry null were not judged: the verdict tells how many.
    const auto all  = results["load_steps"].size();
    const auto open = std::count_if(results["load_steps"].begin(),
                                    results["load_steps"].end(),
                                    [](const Json &step) { return step["accuracy"].is_null(); });
    if (scene.goals.has_targets() && all > 1)
      verdict.add(check_judged_steps(open, all), end);
    results["verdict"] = verdict.json();
  }



  // The check of the targets becomes a part of the verdict.
  template <int dim>
  void
  Recorder<dim>::add_targets(const ErrorControl &control, const std::string &why, const double time)
  {
    verdict.add(check_targets(scene.goals, control, why), time);
    results["verdict"] = verdict.json();
  }



  // Counts of iterations between augmentations are reported for the augmented Lagrangian.
  template <int dim>
  Json
  Recorder<dim>::newton_results(const NewtonReport &report) const
  {
    Json krylov = Json::array(), augmentations = Json::array();
    // Linear iterations of each Newton step, and the numbers of Newton steps between augmentations.
    unsigned int before = 0;
    for (const NewtonStep &row : report.steps)
      {
        if (row.krylov_iterations > 0)
          // Rows without linear iterations do not count as Newton steps.
          krylov.push_back(row.krylov_iterations);
        if (row.augmented)
          {
            augmentations.push_back(krylov.size() - before);
            before = krylov.size();
          }
      }
    Json result = {{"newton_iterations", krylov.size()},
                   {"active_points", report.steps.back().active},
                   {"residual", report.steps.back().residual},
                   {"tangent_positive_definite", !report.tangent_is_indefinite},
                   {"snap_through_ratio", report.speed_ratio},
                   {"friction_over_critical", report.friction_over_critical},
                   {"krylov_iterations", krylov},
                   {"newton_iterations_before_augmentations", augmentations}};
    if (!report.undetermined_modes.empty())
      result["stabilised_modes"] = {{"names", report.undetermined_modes},
                                    {"largest_force", report.stabilisation_force}};
    return result;
  }



  // The verdict needs the largest force of all steps so far, which is updated first.
  template <int dim>
  void
  Recorder<dim>::add_step(const Snapshot<dim> &now,
                          const NewtonReport  &report,
                          const unsigned int   multigrid_cycles,
                          const Json          &accuracy)
  {
    Json one = {{"step", now.step}, {"time", now.time}};
    one.update(newton_results(report));
    one["multigrid_cycles"] = multigrid_cycles;
    one.update(results_at(scene, now, scene.output.probes));
    // An automatic load step with friction was solved as two: its work is the difference to the
    // last one.
    const auto work_of = [](const Json &of_step, const std::string &name) -> double {
      return of_step.at("pairs").at(name).at("total_friction_work");
    };
    for (auto &[name, pair] : one["pairs"].items())
      if (pair.contains("total_friction_work"))
        pair["friction_work"] =
          work_of(one, name) -
          (results["load_steps"].empty() ? 0. : work_of(results["load_steps"].back(), name));
    largest_force = std::max(largest_force, one["largest_force"].get<double>());
    // The checks see the results of this step and the largest force so far.
    verdict.add(check_solution(decisions, now, one, largest_force), now.time);
    results["verdict"] = verdict.json();
    if (!scene.goals.quantities.empty())
      one["accuracy"] = accuracy; // null: not judged
    results["load_steps"].push_back(one);
    writer.write(now, scene.known.pressure);

    // The file grows with each step: it is written only if that takes less than a twentieth of the
    // time since the last writing.
    add_costs();
    // Without this condition, the time for writing would grow with the square of the number of load
    // steps.
    if (clock.wall_time() - written_at >= 20 * writing_takes)
      write();
  }



  // The status 2 marks contact points that alternate; they are counted by pair.
  template <int dim>
  void
  Recorder<dim>::add_failure(const Snapshot<dim> &now, const NewtonReport &report)
  {
    Json one = {{"step", now.step}, {"time", now.time}, {"reason", report.reason}};
    if (!report.steps.empty())
      {
        one["residual"]     = report.steps.back().residual;
        one["gap_residual"] = report.steps.back().gap_residual;
      }
    const auto &mesh = now.elasticity.mesh();
    if (report.worst_body < mesh.n_bodies())
      one["body"] = mesh.body_name(report.worst_body);
    std::vector<unsigned int> chattering(now.pairs.size(), 0);
    auto                      pair = now.contact.origin.pair.begin();
    // Status and pairs of the rows of this rank are in the same order, so that one iterator runs
    // along.
    for (const double status : now.active)
      chattering[*pair++] += status > 1.5;
    Utilities::MPI::sum(chattering, comm, chattering);
    for (unsigned int i = 0; i < now.pairs.size(); ++i)
      one["pairs"].push_back({{"pair", now.pairs[i].name}, {"chattering_points", chattering[i]}});
    results["failed_step"] = one;
    writer.write_failure(now);
  }



  template <int dim>
  void
  Recorder<dim>::add_linear_reference(const LinearReference &linear,
                                      const double           seconds,
                                      const double           cycles)
  {
    results["linear_reference"] = {{"seconds",
                                    {{"assembly", linear.seconds_assembly},
                                     {"preconditioner", linear.seconds_preconditioner},
                                     {"krylov", linear.seconds_krylov}}},
                                   {"krylov_iterations", linear.iterations},
                                   {"near_null_space",
                                    word_of(near_null_spaces(), linear.near_null_space)},
                                   {"contact_seconds", seconds},
                                   {"contact_multigrid_cycles", cycles},
                                   {"time_ratio", seconds / linear.seconds()},
                                   {"cycle_ratio", cycles / linear.iterations}};
  }



  // Sums over all ranks.
  template <int dim>
  void
  Recorder<dim>::add_sizes(const Elasticity<dim>                  &elasticity,
                           const std::vector<ContactSurface<dim>> &surfaces,
                           const GapOperator                      &contact,
                           const std::vector<std::string>         &skipped_items)
  {
    results["cells"] = elasticity.mesh().triangulation().n_global_active_cells();
    results["dofs"]  = elasticity.dof_handler().n_dofs();
    for (unsigned int body = 0; body < scene.bodies.size(); ++body)
      results["degrees"][scene.bodies[body].name] = decisions.degrees[body];
    results["multiplier_dofs"] =
      scene.contact.chosen().has_multipliers() ? contact.n_components() * contact.weight.size() : 0;
    results["skipped"] = skipped_items;
    // Slave faces and candidate points of all pairs on this rank, before the sum.
    unsigned int faces = 0, candidates = 0;
    for (const ContactSurface<dim> &surface : surfaces)
      {
        faces += surface.faces;
        candidates += surface.points.size();
      }
    results["contact_faces"]      = Utilities::MPI::sum(faces, comm);
    results["contact_candidates"] = Utilities::MPI::sum(candidates, comm);
    results["contact_bytes"]      = Utilities::MPI::sum(contact.memory_consumption(), comm);
    results["partition"]          = shares_of_ranks(elasticity, surfaces);
  }



#define INSTANTIATE(dim)                                                                           \
  template void Recorder<dim>::add_preflight(const Json &);                                        \
  template void Recorder<dim>::add_contact_geometry(std::optional<double>, bool);                  \
  template void Recorder<dim>::add_deformation(std::optional<double>, bool);                       \
  template void Recorder<dim>::add_path_error(std::optional<double>, double);                      \
  template void Recorder<dim>::add_deviation_of_loads(double, double);                             \
  template void Recorder<dim>::add_cycle(unsigned int, unsigned int, const Json &);                \
  template void Recorder<dim>::add_accuracy(const Json &,                                          \
                                            const ErrorControl &,                                  \
                                            const std::string &,                                   \
                                            bool);                                                 \
  template void Recorder<dim>::add_targets(const ErrorControl &, const std::string &, double);     \
  template Json Recorder<dim>::newton_results(const NewtonReport &) const;                         \
  template void Recorder<dim>::add_step(const Snapshot<dim> &,                                     \
                                        const NewtonReport &,                                      \
                                        unsigned int,                                              \
                                        const Json &);                                             \
  template void Recorder<dim>::add_failure(const Snapshot<dim> &, const NewtonReport &);           \
  template void Recorder<dim>::add_linear_reference(const LinearReference &, double, double);      \
  template void Recorder<dim>::add_sizes(const Elasticity<dim> &,                                  \
                                         const std::vector<ContactSurface<dim>> &,                 \
                                         const GapOperator &,                                      \
                                         const std::vector<std::string> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
