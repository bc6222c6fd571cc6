// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fields/snapshot.h"

#include <utility>
#include <vector>

namespace Signorini
{
  /// The contact area of one pair, a part of the slave.
  struct ContactPatch
  {
    double area = 0;
    double edge = 0; ///< area of the faces that its edge crosses (2nd degree: of their quarters)
    /// Corners of its bounding box along the axes; empty without contact.
    std::vector<double> from, to;
    /// Extents along the directions of the pair: the smallest and largest x.d for each unit vector
    /// d.
    std::vector<std::pair<double, double>> along;
    /// Semi-axes of the ellipse (2D: the interval) with the same second moments, the largest first.
    std::vector<double> semi_axes;
  };

  /// The contact area from nodal pressures. The edge of contact lies between nodes with and without
  /// pressure. There the square of the pressure goes to zero linearly, as it does where smooth
  /// surfaces lose contact (Hertz), so that its linear extrapolation from the active nodes
  /// determines the edge. With methods that sample at quadrature points, nodes have mean values of
  /// the points around. A contact area that is smaller than that of a node is the area of the
  /// active points. Collective.
  /// @param pressure recovered_pressure()
  template <int dim>
  ContactPatch
  contact_patch(const Snapshot<dim> &snapshot, unsigned int pair, const LA::Vector &pressure);

  /// The largest nodal pressure of one pair, over all ranks; at least the mean pressure, which is
  /// its normal force over the contact area, since a contact area within a face may have no node at
  /// all. Collective.
  /// @param pressure recovered_pressure()
  template <int dim>
  double
  largest_pressure(const Snapshot<dim> &snapshot,
                   unsigned int         pair,
                   const LA::Vector    &pressure,
                   const ContactPatch  &patch);
} // namespace Signorini
