// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/interface/pairing.h"
#include "contact/search/boundary_faces.h"
#include <signorini/contact/pair.h>

namespace Signorini
{
  /// True if what a pair says of its gap is said of the gap at rest: of a given one, of overlaps
  /// that count in part, and of what is never to separate.
  template <int dim>
  bool
  needs_reference_gaps(const ContactPair<dim> &pair);

  /// The gaps that paired points had before anything moved; points that had no projection then are
  /// dropped. Collective.
  /// @param obstacle null if the master is a boundary of a body
  template <int dim>
  std::vector<double>
  reference_gaps(const Elasticity<dim>         &elasticity,
                 const ContactPair<dim>        &pair,
                 const Obstacle<dim>           *obstacle,
                 const BoundaryFaces<dim>      &slave,
                 double                         limit,
                 std::vector<PairedPoint<dim>> &paired);
} // namespace Signorini
