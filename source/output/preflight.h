// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/interface/surface.h"
#include "output/prediction.h"
#include "scene/decisions.h"

#include <nlohmann/json.hpp>

#include <iosfwd>

namespace Signorini
{
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

  /// Print a report.
  /// @param report of preflight()
  /// @param out the stream
  /// @param with_boundaries whether all boundaries are listed with the properties by which they can
  /// be distinguished
  void
  print_preflight(const nlohmann::ordered_json &report, std::ostream &out, bool with_boundaries);
} // namespace Signorini
