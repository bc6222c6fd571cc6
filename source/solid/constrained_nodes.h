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
  /// A constraint of a node along one direction n: the support prescribes n.u.
  template <int dim>
  struct DirectionConstraint
  {
    dealii::Tensor<1, dim> direction; ///< unit
    const Support<dim>    *support;   ///< null: the axis of an axisymmetric body
  };

  /// A node that supports constrain.
  template <int dim>
  struct ConstrainedNode
  {
    /// Degrees of freedom of the components.
    std::array<dealii::types::global_dof_index, dim> dofs;
    /// Position in the reference configuration [length].
    dealii::Point<dim> position;
    /// Number of the connected piece of its body, in Mesh::pieces().
    unsigned int piece;
    /// The constrained directions, in the order of the supports; not necessarily independent.
    std::vector<DirectionConstraint<dim>> prescribed_directions;

    /// The part of a vector along the directions that are not constrained.
    dealii::Tensor<1, dim>
    free_part(const dealii::Tensor<1, dim> &v) const;

    /// The constrained directions, orthonormalised in their order; zero where one depends on those
    /// before it.
    std::vector<dealii::Tensor<1, dim>>
    orthonormal() const;
  };

  /// The constrained nodes by their first degree of freedom.
  template <int dim>
  using ConstrainedNodes = std::map<dealii::types::global_dof_index, ConstrainedNode<dim>>;

  /// Find the nodes of locally owned and ghost cells that are constrained by supports acting at
  /// time t. A set of nodes stands for its nodes, and for all nodes on edges, faces and cells of
  /// the coarse mesh all of whose corners are in it; hanging nodes are skipped, since their
  /// neighbours determine them. On curved boundaries, a node has the mean normal of its faces where
  /// their normals differ by less than 50 degrees, and several directions at corners. Throws
  /// SceneError where a symmetry plane is not plane. Collective.
  template <int dim>
  ConstrainedNodes<dim>
  find_constrained_nodes(const Mesh<dim>                         &mesh,
                         const dealii::DoFHandler<dim>           &dofs,
                         const dealii::AffineConstraints<double> &hanging,
                         const std::vector<Support<dim>>         &supports,
                         double                                   t,
                         Model                                    model);

  /// Add the constraints that supports prescribe at time t, one line for each direction; the caller
  /// closes them. Where supports meet, the first one counts; throws SceneError if the others
  /// contradict it. Collective.
  template <int dim>
  void
  constrain(const ConstrainedNodes<dim>       &nodes,
            const Mesh<dim>                   &mesh,
            double                             t,
            dealii::AffineConstraints<double> &constraints);
} // namespace Signorini
