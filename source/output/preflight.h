// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/interface/surface.h"
#include "output/prediction.h"
#include "scene/decisions.h"

#include <nlohmann/json.hpp>

#include <iosfwd>

namespace Signorini
{
  /// What is known of a scene before it is solved: bodies, motions that contact alone stops, pairs
  /// with their gaps and meshes, what is left out and why, warnings with their cures, and what the
  /// run will take. Keys in words; the printed report shows the same. Collective.
  template <int dim>
  nlohmann::ordered_json
  preflight(const Decisions<dim>                   &decisions,
            const Elasticity<dim>                  &elasticity,
            const std::vector<ContactSurface<dim>> &surfaces,
            const GapOperator                      &contact,
            double                                  seconds);

  /// @param with_boundaries the names of all boundaries too, with what tells them apart
  void
  print_preflight(const nlohmann::ordered_json &report, std::ostream &out, bool with_boundaries);
} // namespace Signorini
