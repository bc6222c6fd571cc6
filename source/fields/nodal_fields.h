// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fields/snapshot.h"

#include <functional>
#include <vector>

namespace Signorini
{
  /// @return whether rows of the gap operator are nodes, not quadrature points. Collective: a rank
  /// may have no node of its own.
  /// @param contact the gap operator
  bool
  samples_nodes(const GapOperator &contact);

  /// @return for methods that sample at quadrature points the row of the first point of a pair on
  /// this rank; the rows of its other points follow.
  /// @param snapshot the solution
  /// @param pair its index
  template <int dim>
  dealii::types::global_dof_index
  first_row(const Snapshot<dim> &snapshot, unsigned int pair);

  /// @return the nodes of a face with a pressure function that are nearest to one without, as
  /// numbers on the face.
  /// @param face the slave face
  /// @param dirichlet_node number of the node on the face
  template <int dim>
  std::vector<unsigned int>
  nearest_free(const SlaveFace<dim> &face, unsigned int dirichlet_node);

  /// A function that returns the value at a node without multiplier (by its number on a face), from
  /// the nearest node that has one.
  template <int dim>
  using PrescribedNodeValue = std::function<
    double(const SlaveFace<dim> &face, unsigned int dirichlet_node, unsigned int near)>;

  /// Set the values of nodes that have no pressure function on any face to the mean over their
  /// faces and nearest nodes. Collective.
  /// @param snapshot the solution
  /// @param pair its index
  /// @param value at a node, from one of its nearest nodes
  /// @param field without ghost values, which is changed
  template <int dim>
  void
  fill_dirichlet_nodes(const Snapshot<dim>            &snapshot,
                       unsigned int                    pair,
                       const PrescribedNodeValue<dim> &value,
                       LA::Vector                     &field);

  /// Set the values of nodes of degree 2 on triangles to the mean of the corners beside them, since
  /// the pressure is of degree 1 there. Collective.
  /// @param snapshot the solution
  /// @param pair its index
  /// @param field without ghost values, which is changed
  template <int dim>
  void
  fill_between(const Snapshot<dim> &snapshot, unsigned int pair, LA::Vector &field);

  /// @return a quantity on the rows of the gap operator as a field on the slave surface of one
  /// pair: a vector of the layout of the displacement (without ghost values) that has the value of
  /// a node at the first degree of freedom of the node, with hanging nodes interpolated, and zero
  /// everywhere else. Rows that are nodes have their values; for rows that are quadrature points,
  /// the node has the mean weighted with its shape function psi: int psi v dA / int psi dA. Nodes
  /// without pressure function have the values of their neighbours on the face. Collective.
  /// @param snapshot the solution
  /// @param values one for each row
  /// @param pair its index
  template <int dim>
  LA::Vector
  nodal_field(const Snapshot<dim> &snapshot, const LA::Vector &values, unsigned int pair);

  /// @return a nodal field at a contact point.
  /// @param surface to which the point belongs
  /// @param point the contact point
  /// @param field with ghost values
  template <int dim>
  double
  value_at(const ContactSurface<dim> &surface,
           const ContactPoint<dim>   &point,
           const LA::Vector          &field);

  /// @return one at nodes that have a value in nodal_field(), less than one elsewhere (zero except
  /// at hanging nodes). Collective.
  /// @param snapshot the solution
  /// @param pair its index
  template <int dim>
  LA::Vector
  nodal_coverage(const Snapshot<dim> &snapshot, unsigned int pair);
} // namespace Signorini
