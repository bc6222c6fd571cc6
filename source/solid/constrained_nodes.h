// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh/mesh.h"
#include <signorini/solid/boundary_conditions.h>
#include <signorini/solid/model.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/lac/affine_constraints.h>

#include <array>
#include <map>
#include <vector>

namespace Signorini
{
  /// A direction in which a node is held: n.u is what the support prescribes.
  template <int dim>
  struct DirectionConstraint
  {
    dealii::Tensor<1, dim> direction; ///< unit
    const Support<dim>    *support;   ///< null: the axis of an axisymmetric body
  };

  /// A node on a support.
  template <int dim>
  struct ConstrainedNode
  {
    std::array<dealii::types::global_dof_index, dim> dofs;
    dealii::Point<dim>                               position;
    unsigned int                                     piece;      ///< of Mesh::pieces()
    std::vector<DirectionConstraint<dim>> prescribed_directions; ///< in the order of the supports

    /// The part of a vector in which the node is free to move.
    dealii::Tensor<1, dim>
    free_part(const dealii::Tensor<1, dim> &v) const;

    /// Its holds' directions, each orthogonal to those before it; zero where it depends on them.
    std::vector<dealii::Tensor<1, dim>>
    orthonormal() const;
  };

  /// By their first degree of freedom.
  template <int dim>
  using ConstrainedNodes = std::map<dealii::types::global_dof_index, ConstrainedNode<dim>>;

  /// The nodes on cells that this rank knows which supports that act at time t hold. A set of nodes
  /// stands for these, and for all nodes on edges, faces and cells of the coarse mesh with all
  /// corners in it; hanging nodes follow their neighbours and are left out. On curved boundaries, a
  /// node has the mean of its faces' normals where they differ by less than 50 degrees, and several
  /// directions at corners. Throws SceneError where a symmetry plane is not plane. Collective.
  template <int dim>
  ConstrainedNodes<dim>
  find_constrained_nodes(const Mesh<dim>                         &mesh,
                         const dealii::DoFHandler<dim>           &dofs,
                         const dealii::AffineConstraints<double> &hanging,
                         const std::vector<Support<dim>>         &supports,
                         double                                   t,
                         Model                                    model);

  /// Add what the supports prescribe at time t, one line a direction, to be closed by the caller.
  /// Where they meet, the first one counts; throws SceneError if the others do not agree with it.
  /// Collective.
  template <int dim>
  void
  constrain(const ConstrainedNodes<dim>       &nodes,
            const Mesh<dim>                   &mesh,
            double                             t,
            dealii::AffineConstraints<double> &constraints);
} // namespace Signorini
