// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fields/snapshot.h"

#include <nlohmann/json.hpp>

namespace Signorini
{
  /// @return the entries of results.json of a pair with friction: force, stick zone, the largest
  /// tangential traction, slips, the work that friction takes from the bodies, and the violations
  /// of the law. Collective.
  /// @param snapshot the solution
  /// @param force the part of the force on the slave that is due to tangential tractions
  /// @param area of the contact zone
  /// @param pair its index
  template <int dim>
  nlohmann::ordered_json
  friction_results(const Snapshot<dim>          &snapshot,
                   const dealii::Tensor<1, dim> &force,
                   double                        area,
                   unsigned int                  pair);
} // namespace Signorini
