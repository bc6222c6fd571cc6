// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/search/configuration.h"
#include "verdict/monitored_surfaces.h"

#include <map>
#include <utility>

namespace Signorini
{
  /// Faces that may be in another body or in an obstacle where no pair looks for contact, by boxes
  /// of moved vertices alone: nearly always there are few of them.
  template <int dim>
  class PenetrationCandidates
  {
  public:
    /// Collective.
    PenetrationCandidates(const Scene<dim>             &scene,
                          const Configuration<dim>     &configuration,
                          const MonitoredSurfaces<dim> &watched);

    /// True if the face may be inside of another body or of an obstacle.
    bool
    may_penetrate(const CellIterator<dim> &cell, unsigned int face) const;

    /// True if the face may penetrate something, or is near a face of another body that may.
    bool
    counts(const CellIterator<dim> &cell, unsigned int face) const;

  private:
    std::map<std::pair<unsigned int, unsigned int>, bool>
      found; ///< by active cell and face: may_penetrate() of those that count
  };
} // namespace Signorini
