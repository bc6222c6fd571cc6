// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/interface/surface.h"
#include "contact/search/boundary_faces.h"

#include <set>

namespace Signorini
{
  /// True if a node of a slave face can carry a multiplier. False where its displacement along the
  /// normal is prescribed, or nearly so, and for nodes of degree 2 on the axis of axisymmetric
  /// models, whose functions have no area (int N r dr = 0).
  /// @param first first degree of freedom of the node
  template <int dim>
  bool
  carries_pressure(const Elasticity<dim>          &elasticity,
                   dealii::types::global_dof_index first,
                   unsigned int                    degree,
                   const FacePatch<dim>           &face,
                   const dealii::Point<dim - 1>   &xi);

  using NodeIndices = std::set<dealii::types::global_dof_index>;

  /// The nodes of boundaries on locally owned and ghost cells, by their first degrees of freedom.
  template <int dim>
  NodeIndices
  nodes_of_boundaries(const Elasticity<dim> &elasticity, const std::vector<std::string> &names);

  /// The nodes of a slave face with multipliers of their own, by their first degrees of freedom,
  /// and the share of its area that has a projection.
  struct PressureNodes
  {
    /// First degrees of freedom of the nodes.
    std::vector<dealii::types::global_dof_index> own;
    /// Share of the face's area with a projection, in [0,1].
    double covered = 0;
  };

  /// Set the multiplier shape functions at the points of a surface (`multiplier_shape` and
  /// `interpolation`) and at its segment edge points, on faces that have contact points. If the
  /// pressure is an independent unknown, nodes whose normal displacement is prescribed or whose
  /// area the master hardly covers have no multipliers, and their neighbours take over, see
  /// PressureBasis.
  /// @param ids those of the slave; a face none of whose nodes has a multiplier takes those of the
  /// faces beside
  /// @param elsewhere first degrees of freedom of nodes that have multipliers of other pairs, and
  /// none here either, but where a face has no other nodes
  /// @param paired_points the paired points of `points`, in the same order, sorted by faces
  /// @param paired_edge_points the paired points of `edge_points`, in the same order, sorted by
  /// faces
  /// @return one entry for each slave face; without nodes where all are prescribed, or where there
  /// are no points
  template <int dim>
  std::vector<PressureNodes>
  set_pressure_functions(const Elasticity<dim>               &elasticity,
                         const ContactMethod                 &method,
                         Basis                                basis,
                         const BoundaryFaces<dim>            &slave,
                         const BoundaryIds                   &ids,
                         const NodeIndices                   &elsewhere,
                         const std::vector<PairedPoint<dim>> &paired_points,
                         const std::vector<PairedPoint<dim>> &paired_edge_points,
                         std::vector<ContactPoint<dim>>      &points,
                         std::vector<EdgeContactPoint<dim>>  &edge_points);
} // namespace Signorini
