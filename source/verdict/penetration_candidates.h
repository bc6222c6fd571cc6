// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/search/configuration.h"
#include "verdict/monitored_surfaces.h"

#include <map>
#include <utility>

namespace Signorini
{
  /// The faces that may be inside of another body or an obstacle where no pair detects contact, by
  /// boxes of moved vertices only: in most solutions there are few.
  template <int dim>
  class PenetrationCandidates
  {
  public:
    /// Find the candidates. Collective.
    /// @param scene the scene
    /// @param configuration current positions
    /// @param watched where pairs detect contact
    PenetrationCandidates(const Scene<dim>             &scene,
                          const Configuration<dim>     &configuration,
                          const MonitoredSurfaces<dim> &watched);

    /// @return whether a face may be inside of another body or of an obstacle.
    /// @param cell its cell
    /// @param face its number
    bool
    may_penetrate(const CellIterator<dim> &cell, unsigned int face) const;

    /// @return whether a face may penetrate something, or is near a face of another body that may.
    /// @param cell its cell
    /// @param face its number
    bool
    counts(const CellIterator<dim> &cell, unsigned int face) const;

  private:
    std::map<std::pair<unsigned int, unsigned int>, bool>
      /// may_penetrate() of the faces that count, by active cell and face.
      found;
  };
} // namespace Signorini
