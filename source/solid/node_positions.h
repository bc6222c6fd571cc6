// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/displacements.h"

#include <vector>

namespace Signorini
{
  /// Where the unknowns of a space of displacements are.
  struct NodePositions
  {
    unsigned int dim = 0;
    /// Coordinates of the nodes of this rank, dim each [length].
    std::vector<double> coordinates;
    /// Number of nodes of all ranks at the end that have no position, those of rigid bodies: one of
    /// their translation and one of their rotation.
    unsigned int n_rigid = 0;
    /// Number of those of this rank, with coordinates zero.
    unsigned int n_own_rigid = 0;
  };

  /// The positions of the nodes of a space on the mesh.
  /// @param owned degrees of freedom of the mesh, followed by those of rigid bodies
  template <int dim>
  NodePositions
  node_positions(const Mesh<dim>                     &mesh,
                 const dealii::DoFHandler<dim>       &dofs,
                 const dealii::hp::FECollection<dim> &elements,
                 const dealii::IndexSet              &owned);

  /// The positions of the nodes of the bodies.
  template <int dim>
  NodePositions
  node_positions(const Displacements<dim> &displacements);
} // namespace Signorini
