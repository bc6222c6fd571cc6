// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fields/snapshot.h"

#include <utility>
#include <vector>

namespace Signorini
{
  /// Where one pair is in contact: a part of the slave.
  struct ContactPatch
  {
    double area = 0;
    double edge = 0; ///< area of the faces that its edge crosses (2nd degree: of their quarters)
    /// Corners of the box around it, along the axes; empty without contact.
    std::vector<double> from, to;
    /// Likewise along the directions of the pair: the lowest and highest x.d of unit vectors d.
    std::vector<std::pair<double, double>> along;
    /// Of the ellipse (2D: the interval) with the same second moments, the largest first.
    std::vector<double> semi_axes;
  };

  /// Nodes carry pressure or not; the edge of contact lies between. There the square of the
  /// pressure goes to zero linearly, as it does where smooth surfaces lose contact (Hertz), so that
  /// its linear continuation from the nodes in contact tells where. Of methods that sample at
  /// points, nodes have the means about them. Collective.
  /// A zone that is smaller than what belongs to a node is that of the points in contact.
  /// @param pressure recovered_pressure()
  template <int dim>
  ContactPatch
  contact_patch(const Snapshot<dim> &snapshot, unsigned int pair, const LA::Vector &pressure);

  /// The largest of the nodal pressures of one pair, on all ranks; at least the mean pressure, its
  /// normal force over the area of contact, which zones within a face have although no node does.
  /// Collective.
  /// @param pressure recovered_pressure()
  template <int dim>
  double
  largest_pressure(const Snapshot<dim> &snapshot,
                   unsigned int         pair,
                   const LA::Vector    &pressure,
                   const ContactPatch  &patch);
} // namespace Signorini
