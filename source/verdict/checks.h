// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "accuracy/error_control.h"
#include "fields/snapshot.h"
#include "scene/decisions.h"
#include "verdict/verdict.h"

namespace Signorini
{
  /// @return the results of all checks of the solution of one load step, the same on all ranks.
  /// Collective.
  /// @param decisions the scene with all choices
  /// @param now the solution
  /// @param results entry of results.json of this step
  /// @param largest_force of all load steps so far
  template <int dim>
  std::vector<CheckResult>
  check_solution(const Decisions<dim>         &decisions,
                 const Snapshot<dim>          &now,
                 const nlohmann::ordered_json &results,
                 double                        largest_force);

  /// @return the check of the accuracy of the load path.
  /// @param error of tangential tractions or work, the sum over all load steps so far, relative
  /// @param limit `Load steps/Path error`
  std::vector<CheckResult>
  check_path_error(double error, double limit);

  /// @return the check that load steps follow the loads.
  /// @param deviation see Equilibrium::deviation_of_loads()
  std::vector<CheckResult>
  check_deviation_of_loads(double deviation);

  /// Extreme values of one body.
  struct Extremes
  {
    /// Largest displacement [length] at the centres of cells.
    double motion = 0;
    /// Largest norm of the displacement gradient there.
    double gradient = 0;
    /// Largest rotation there [radian].
    double largest_rotation = 0;
    /// The mean rotation, by volume [radian].
    double mean_rotation = 0;
    /// Largest norm of the strain, the symmetric part of the gradient, there.
    double strain = 0;
  };

  /// @return the extreme values of each body. Collective.
  /// @param now the solution
  template <int dim>
  std::vector<Extremes>
  extremes_of_bodies(const Snapshot<dim> &now);

  /// @return whether a force is larger than the rounding of the forces in the scene.
  /// @param force any force
  /// @param scale a typical force of the scene
  bool
  is_significant(double force, double scale);

  /// @return one check for each quantity: whether its error bound is within the target.
  /// @param goals quantities and targets
  /// @param control the histories of errors
  /// @param why reason why targets were not reached
  std::vector<CheckResult>
  check_targets(const Goals &goals, const ErrorControl &control, const std::string &why);

  /// @return the check whether load steps of a run with targets have no error bounds.
  /// @param not_judged number of such load steps
  /// @param all number of all load steps
  std::vector<CheckResult>
  check_judged_steps(unsigned int not_judged, unsigned int all);

  /// @return a warning for each stress whose exact value has no limit.
  std::vector<CheckResult>
  check_limits(const Goals &goals, const ErrorControl &control);

  /// Check that error bounds contain the errors of former load steps.
  /// @param does_not whether the state keeps something of them that the bounds do not contain
  std::vector<CheckResult>
  check_former_steps(bool does_not);

  // The single checks:

  /// @return checks of motions larger than the model, and of displacement gradients whose squares
  /// small strain neglects.
  /// @param now the solution
  /// @param extremes of the bodies
  template <int dim>
  std::vector<CheckResult>
  check_motions(const Snapshot<dim> &now, const std::vector<Extremes> &extremes);

  /// @return the check of volumetric locking in nearly incompressible bodies in displacement form,
  /// by the share of spurious volumetric energy. Collective.
  /// @param now the solution
  template <int dim>
  std::vector<CheckResult>
  check_locking(const Snapshot<dim> &now);

  /// @return checks of each pair: inactive pairs, contact zones of a few faces, large motions of
  /// surfaces, misaligned normals, initial overlaps larger than faces, facets, choice of the slave,
  /// penetration of penalty methods. For pairs whose force is negligible beside the scale,
  /// inactivity alone is checked. Collective.
  /// @param decisions the scene with all choices
  /// @param now the solution
  /// @param extremes of the bodies
  /// @param results entry of results.json of this step
  /// @param scale a typical force of the scene
  template <int dim>
  std::vector<CheckResult>
  check_pairs(const Decisions<dim>         &decisions,
              const Snapshot<dim>          &now,
              const std::vector<Extremes>  &extremes,
              const nlohmann::ordered_json &results,
              double                        scale);

  /// @return the check for surfaces that penetrate where no pair detects contact: another body, an
  /// obstacle, or a plane of symmetry of their body; and points of a surface in self-contact that
  /// were assigned to the same side. Penetrations are detected where they are less than half a cell
  /// deep, as they are somewhere along the edge of any overlap. With small strain, other bodies and
  /// obstacles are checked only. Collective.
  /// @param scene the scene
  /// @param now the solution
  template <int dim>
  CheckResult
  check_undetected_penetration(const Scene<dim> &scene, const Snapshot<dim> &now);

  /// @return the check whether the mesh has nodes between those of constraint equations; none
  /// without these. Collective.
  /// @param now the solution
  template <int dim>
  std::vector<CheckResult>
  check_equations(const Snapshot<dim> &now);

  /// @return one check for each load that varies within faces: the difference of its integrals by
  /// two quadrature rules. Collective.
  /// @param scene the scene
  /// @param now the solution
  template <int dim>
  std::vector<CheckResult>
  check_loads(const Scene<dim> &scene, const Snapshot<dim> &now);

  /// @return the check that the faces at the edges of fluids are small, for each load that has one.
  /// @param results entry of results.json of this step
  /// @param scale the largest force
  std::vector<CheckResult>
  check_fluids(const nlohmann::ordered_json &results, double scale);

  /// @return the check for loads and supports that an import has omitted: a warning, or a failure
  /// if nothing acts without them; empty if nothing was omitted.
  /// @param scene the scene
  /// @param acts whether any force or motion acts
  template <int dim>
  std::vector<CheckResult>
  check_skipped_items(const Scene<dim> &scene, bool acts);

  /// @return the checks of the balance of forces and moments of each body.
  /// @param results entry of results.json of this step
  /// @param scale a typical force of the scene
  /// @param small largest share of it that passes
  std::vector<CheckResult>
  check_balance(const nlohmann::ordered_json &results, double scale, double small);
} // namespace Signorini
