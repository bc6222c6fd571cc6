// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/interface/surface.h"

namespace Signorini
{
  /// True if two of the surfaces have contact points at the same positions of a slave face of this
  /// rank. Where one of them carries pressure, the normal stress of the bodies is not that of the
  /// other's constraint, so that the term theta S^T of Nitsche's method would be inconsistent. Not
  /// collective.
  template <int dim>
  bool
  have_coinciding_points(const std::vector<ContactSurface<dim>> &surfaces);
} // namespace Signorini
