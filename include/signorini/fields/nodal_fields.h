#pragma once

#include <signorini/fields/snapshot.h>

namespace Signorini
{
  /// True if the method samples at nodes. Collective: a rank may have no node of its own.
  bool
  samples_nodes(const GapOperator &contact);

  /// Of methods that sample at points: the row of the first point of a pair on this rank; those of
  /// the others follow.
  template <int dim>
  dealii::types::global_dof_index
  first_row(const Snapshot<dim> &snapshot, unsigned int pair);

  /// A quantity on the rows of the gap operator as a field on the slave surface of one pair: a
  /// vector of the layout of the displacement (without ghosts) with the value of a node at the
  /// node's first degree of freedom, hanging nodes interpolated, zero everywhere else. Rows that
  /// are nodes give their values; of quadrature points, the node takes the mean weighted with its
  /// shape function psi: int psi v dA / int psi dA. Collective.
  template <int dim>
  LA::Vector
  nodal_field(const Snapshot<dim> &snapshot, const LA::Vector &values, unsigned int pair);

  /// One at nodes that nodal_field() gives a value, below one elsewhere (zero but at hanging
  /// nodes).
  template <int dim>
  LA::Vector
  nodal_coverage(const Snapshot<dim> &snapshot, unsigned int pair);
} // namespace Signorini
