// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fields/snapshot.h"
#include <signorini/scene/scene.h>

#include <set>
#include <string>
#include <utility>

namespace Signorini
{
  /// Where pairs look for contact. A kind of faces is the number of a boundary; plus that of all
  /// boundaries if it is a slave of a surface that touches itself. Pairs without any pressure are
  /// idle: surfaces that go through each other all the same have not seen it. (Unless their initial
  /// overlap is not to count yet.)
  template <int dim>
  class MonitoredSurfaces
  {
  public:
    MonitoredSurfaces(const Scene<dim> &scene, const Snapshot<dim> &now);

    unsigned int
    kind(const CellIterator<dim> &cell, unsigned int face) const;

    /// A pair looks whether these boundaries, one and the same perhaps, touch themselves.
    bool
    is_self(unsigned int a, unsigned int b) const;

    bool
    is_monitored(unsigned int a, unsigned int b) const;

    bool
    is_monitored(unsigned int a, const std::string &obstacle) const;

    /// With any surface of that body, idle or not.
    bool
    has_pair(unsigned int a, unsigned int body) const;

    bool
    is_inactive(unsigned int a, unsigned int b) const;

    bool
    is_inactive(unsigned int a, const std::string &obstacle) const;

    /// The first one.
    std::string
    name(unsigned int kind) const;

  private:
    std::pair<unsigned int, unsigned int>
    boundaries(unsigned int a, unsigned int b) const;

    const Mesh<dim>                                  &mesh;
    std::set<std::pair<unsigned int, unsigned int>>   pairs, inactive_pairs, selves;
    std::set<std::pair<unsigned int, unsigned int>>   with_bodies; ///< boundary, body
    std::set<std::pair<unsigned int, std::string>>    at_obstacles, idle_at_obstacles;
    std::set<std::pair<dealii::CellId, unsigned int>> slaves;
  };
} // namespace Signorini
