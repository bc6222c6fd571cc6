// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/interface/pairing.h"
#include "contact/search/boundary_faces.h"
#include <signorini/contact/pair.h>

namespace Signorini
{
  /// True if the settings of a pair refer to gaps in the reference configuration: a prescribed
  /// initial gap, an interference whose share changes, or a pair without separation.
  template <int dim>
  bool
  needs_reference_gaps(const ContactPair<dim> &pair);

  /// The reference gaps of paired points [length]. Points that had no projection in the reference
  /// configuration are removed from `paired`. Collective.
  /// @param obstacle null if the master is a boundary of a body
  /// @param limit search radius [length]
  template <int dim>
  std::vector<double>
  reference_gaps(const Elasticity<dim>         &elasticity,
                 const ContactPair<dim>        &pair,
                 const Obstacle<dim>           *obstacle,
                 const BoundaryFaces<dim>      &slave,
                 double                         limit,
                 std::vector<PairedPoint<dim>> &paired);
} // namespace Signorini
