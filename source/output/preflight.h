// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/interface/surface.h"
#include "scene/decisions.h"
#include "solid/elasticity.h"
#include <signorini/scene/scene.h>

#include <nlohmann/json.hpp>

#include <iosfwd>

namespace Signorini
{
  /// The predicted costs of a run by a simple model: the time so far, plus multiples of the
  /// assembly time, which is measured on a few cells, for each cell and contact point; and a number
  /// of bytes for each entry of the stiffness matrix (whether or not it is assembled) and contact
  /// point. For usual scenes the time is right within a factor of two, and the memory within 30 %;
  /// scripts/calibrate compares.
  struct Prediction
  {
    /// Time of assembling one cell [s], as measured.
    double seconds_per_cell = 0;
    /// Time of the whole run [s]; NaN for direct solvers and finite strain.
    double seconds = 0;
    /// Time so far [s]: mesh and search.
    double seconds_before = 0;
    /// Largest memory of a rank [MB]; NaN for direct solvers.
    double memory_mb = 0;
  };

  /// @return the predicted costs, for the present mesh and the refinements to come. Collective.
  /// @param scene the scene
  /// @param elasticity the model on the present mesh
  /// @param n_points contact points of this rank
  /// @param seconds since the start of the program; this work is repeated on each mesh, in
  /// proportion to its surface
  template <int dim>
  Prediction
  predict(const Scene<dim>      &scene,
          const Elasticity<dim> &elasticity,
          unsigned int           n_points,
          double                 seconds);

  /// @return a report on a scene before it is solved: bodies, rigid-body modes that contact alone
  /// constrains, pairs with their gaps and meshes, what is omitted and why, warnings with advice,
  /// and the predicted costs. Collective.
  /// @param decisions the scene with all choices
  /// @param elasticity the model
  /// @param surfaces contact surfaces of all pairs
  /// @param contact the gap operator
  /// @param seconds since the start of the program
  template <int dim>
  nlohmann::ordered_json
  preflight(const Decisions<dim>                   &decisions,
            const Elasticity<dim>                  &elasticity,
            const std::vector<ContactSurface<dim>> &surfaces,
            const GapOperator                      &contact,
            double                                  seconds);

  /// @return the part of the report about contact pairs, by their names. Collective.
  /// @param decisions the scene with all choices
  /// @param elasticity the model
  /// @param surfaces contact surfaces of all pairs
  /// @param warnings to which those about pairs are appended
  template <int dim>
  nlohmann::ordered_json
  preflight_of_pairs(const Decisions<dim>                   &decisions,
                     const Elasticity<dim>                  &elasticity,
                     const std::vector<ContactSurface<dim>> &surfaces,
                     nlohmann::ordered_json                 &warnings);

  /// Print a report.
  /// @param report of preflight()
  /// @param out the stream
  /// @param with_boundaries whether all boundaries are listed with the properties by which they can
  /// be distinguished
  void
  print_preflight(const nlohmann::ordered_json &report, std::ostream &out, bool with_boundaries);
} // namespace Signorini
