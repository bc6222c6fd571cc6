// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "accuracy/error_control.h"
#include "fields/snapshot.h"
#include "scene/decisions.h"
#include "verdict/verdict.h"

namespace Signorini
{
  /// All questions about the solution of one load step. Collective; the same on all ranks.
  /// @param results what results.json says of the step
  /// @param largest_force of all load steps so far
  template <int dim>
  std::vector<CheckResult>
  check_solution(const Decisions<dim>         &decisions,
                 const Snapshot<dim>          &now,
                 const nlohmann::ordered_json &results,
                 double                        largest_force);

  /// Extreme values of one body.
  struct Extremes
  {
    double motion           = 0; ///< largest displacement, in the middle of cells
    double gradient         = 0; ///< largest norm of its gradient there
    double largest_rotation = 0; ///< largest rotation there [radian]
  };

  /// Body by body.
  template <int dim>
  std::vector<Extremes>
  extremes_of_bodies(const Snapshot<dim> &now);

  /// A force is more than rounding of those that act in the scene. @param scale a force of these
  bool
  is_significant(double force, double scale);

  /// Error bars larger than wanted. @param why they are, in words
  std::vector<CheckResult>
  check_targets(const Goals &goals, const ErrorControl &control, const std::string &why);

  /// Load steps of a run with targets that were neither refined for nor have bars.
  std::vector<CheckResult>
  check_judged_steps(unsigned int not_judged, unsigned int all);

  // One after the other:

  /// Motions larger than the scene, and gradients of the displacement of which the theory neglects
  /// the squares: strains or rotations beyond small.
  template <int dim>
  std::vector<CheckResult>
  check_motions(const Snapshot<dim> &now, const std::vector<Extremes> &extremes);

  /// Nearly incompressible bodies whose cells cannot change shape without changing volume: the
  /// share of the energy that this takes.
  template <int dim>
  std::vector<CheckResult>
  check_locking(const Scene<dim> &scene, const Snapshot<dim> &now);

  /// Pair by pair: those that never act, zones of a few faces, surfaces that move far or are far
  /// from opposite, overlaps larger than faces, facets, sides, penetration of penalties. Of pairs
  /// whose force does not count beside the scale, those that never act alone.
  template <int dim>
  std::vector<CheckResult>
  check_pairs(const Decisions<dim>         &decisions,
              const Snapshot<dim>          &now,
              const std::vector<Extremes>  &extremes,
              const nlohmann::ordered_json &results,
              double                        scale);

  /// Surfaces that go through each other where no pair looks for contact, through an obstacle, or
  /// through a plane of symmetry of their body; and places of a surface that touches itself which
  /// SelfContact has not told apart. It is seen where they do so by less than half a cell, as they
  /// do somewhere. Of small strain, other bodies and obstacles alone.
  template <int dim>
  CheckResult
  check_undetected_penetration(const Scene<dim> &scene, const Snapshot<dim> &now);

  /// Pressures and tractions that change within faces, as those that jump: their integrals by two
  /// rules.
  template <int dim>
  std::vector<CheckResult>
  check_loads(const Scene<dim> &scene, const Snapshot<dim> &now);

  /// What acts on bodies or bears them and an import has left out: warned of, and no answer where
  /// nothing acts without it. Nothing if there is none.
  /// @param acts something does
  template <int dim>
  std::vector<CheckResult>
  check_skipped_items(const Scene<dim> &scene, bool acts);

  /// Forces and moments in balance.
  /// @param scale a force beside which they are to be small
  /// @param small share of it that is
  std::vector<CheckResult>
  check_balance(const nlohmann::ordered_json &results, double scale, double small);
} // namespace Signorini
