// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fields/snapshot.h"

#include <utility>
#include <vector>

namespace Signorini
{
  /// The contact zone of one pair, a part of the slave surface; the same on all ranks.
  struct ContactPatch
  {
    /// Area [length^(dim-1); axisymmetric: length^2].
    double area = 0;
    /// Area of the parts of faces that its edge crosses (2nd degree: of halves or quarters of
    /// faces).
    double edge = 0;
    /// Lowest and highest coordinates along the axes; empty without contact.
    std::vector<double> from, to;
    /// Extents along the directions of the pair: the smallest and largest x.d for each unit vector
    /// d.
    std::vector<std::pair<double, double>> along;
    /// Semi-axes of the ellipse (2D: the interval) with the same second moments, the largest first.
    std::vector<double> semi_axes;
  };

  /// Determine a zone as the contact zone below: the part of the slave surface where points are
  /// marked, at whose edge the square of a density decreases to zero linearly. Collective.
  /// @param snapshot the solution
  /// @param pair its index
  /// @param density at the nodes, see recovered_density()
  /// @param marks 1 at the rows of the gap operator inside of the zone, else 0
  /// @return the zone
  template <int dim>
  ContactPatch
  contact_patch(const Snapshot<dim> &snapshot,
                unsigned int         pair,
                const LA::Vector    &density,
                const LA::Vector    &marks);

  /// Determine the contact zone from nodal pressures. The edge of contact is between nodes with and
  /// without pressure. There the square of the pressure decreases to zero linearly, as it does
  /// where smooth surfaces lose contact (Hertz), so that its linear extrapolation from the active
  /// nodes determines the edge. For methods that sample at quadrature points, nodes have mean
  /// values of the points around. A contact area that is smaller than that of a node is the area of
  /// the active points. Collective.
  /// @param snapshot the solution
  /// @param pair its index
  /// @param pressure recovered_pressure() of the pair
  /// @return the zone
  template <int dim>
  ContactPatch
  contact_patch(const Snapshot<dim> &snapshot, const unsigned int pair, const LA::Vector &pressure)
  {
    return contact_patch(snapshot, pair, pressure, snapshot.active);
  }

  /// @return the largest nodal pressure of one pair, over all ranks; at least the mean pressure,
  /// which is the normal force over the contact area, since a contact area within a face may have
  /// no node at all. Collective.
  /// @param snapshot the solution
  /// @param pair its index
  /// @param pressure recovered_pressure() of the pair
  /// @param patch its contact zone
  template <int dim>
  double
  largest_pressure(const Snapshot<dim> &snapshot,
                   unsigned int         pair,
                   const LA::Vector    &pressure,
                   const ContactPatch  &patch);
} // namespace Signorini
