// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/point.h>

#include <string>

namespace Signorini
{
  /// The message about a formula that has no finite value at a position and time.
  template <int dim>
  std::string
  not_finite(const std::string        &key,
             const std::string        &formula,
             const dealii::Point<dim> &x,
             double                    t);
} // namespace Signorini
