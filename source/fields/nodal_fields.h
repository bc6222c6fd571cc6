// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fields/snapshot.h"

#include <functional>
#include <vector>

namespace Signorini
{
  /// True if the method samples at nodes. Collective: a rank may have no node of its own.
  bool
  samples_nodes(const GapOperator &contact);

  /// For methods that sample at quadrature points: the row of the first point of a pair on this
  /// rank; those of the other points follow.
  template <int dim>
  dealii::types::global_dof_index
  first_row(const Snapshot<dim> &snapshot, unsigned int pair);

  /// The nodes with a pressure of their own that are nearest to one without on its face; by
  /// numbers.
  template <int dim>
  std::vector<unsigned int>
  nearest_free(const SlaveFace<dim> &face, unsigned int dirichlet_node);

  /// The value at a node without a multiplier of its own (by its number on a face), from the
  /// nearest node that has one.
  template <int dim>
  using PrescribedNodeValue = std::function<
    double(const SlaveFace<dim> &face, unsigned int dirichlet_node, unsigned int near)>;

  /// Sets nodes that carry no pressure on any face to the mean over faces and nearest nodes.
  /// Collective.
  template <int dim>
  void
  fill_dirichlet_nodes(const Snapshot<dim>            &snapshot,
                       unsigned int                    pair,
                       const PrescribedNodeValue<dim> &value,
                       LA::Vector                     &field);

  /// A quantity on the rows of the gap operator as a field on the slave surface of one pair: a
  /// vector of the layout of the displacement (without ghosts) with the value of a node at the
  /// node's first degree of freedom, hanging nodes interpolated, zero everywhere else. Rows that
  /// are nodes give their values; of quadrature points, the node takes the mean weighted with its
  /// shape function psi: int psi v dA / int psi dA. Nodes that carry none have
  /// the values of their neighbours on the face. Collective.
  template <int dim>
  LA::Vector
  nodal_field(const Snapshot<dim> &snapshot, const LA::Vector &values, unsigned int pair);

  /// A nodal field at a point of the surface.
  /// @param field with ghosts
  template <int dim>
  double
  value_at(const ContactSurface<dim> &surface,
           const ContactPoint<dim>   &point,
           const LA::Vector          &field);

  /// One at nodes that nodal_field() gives a value, below one elsewhere (zero but at hanging
  /// nodes).
  template <int dim>
  LA::Vector
  nodal_coverage(const Snapshot<dim> &snapshot, unsigned int pair);
} // namespace Signorini
