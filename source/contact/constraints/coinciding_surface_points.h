// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/interface/surface.h"

namespace Signorini
{
  /// Do two of the surfaces have contact points at the same places of a slave face? Where one of
  /// them has a pressure, the bodies have a normal stress of which the other one knows nothing.
  /// Local: of the faces of this rank.
  template <int dim>
  bool
  have_coinciding_points(const std::vector<ContactSurface<dim>> &surfaces);
} // namespace Signorini
