// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/interface/surface.h"
#include "contact/search/boundary_faces.h"

namespace Signorini
{
  /// False for a node of a slave face whose displacement along the normal is prescribed, or nearly
  /// so, and for one of degree 2 on the axis, whose function has no area (int N r dr = 0).
  /// @param first degree of freedom of the node
  template <int dim>
  bool
  carries_pressure(const Elasticity<dim>          &elasticity,
                   dealii::types::global_dof_index first,
                   unsigned int                    degree,
                   const FacePatch<dim>           &face,
                   const dealii::Point<dim - 1>   &xi);

  /// On a slave face: the nodes with functions of their own, by their first degrees of freedom, and
  /// the share of its area that has a projection.
  struct PressureNodes
  {
    std::vector<dealii::types::global_dof_index> own;
    double                                       covered = 0;
  };

  /// Sets the functions of the pressure at the points of a surface (`shape` and `interpolation`).
  /// Nodes that cannot move along the normal carry none if the pressure is an unknown of its own,
  /// nor do those whose area the master hardly covers; their neighbours take over. Those of segment
  /// edges
  /// (`shape`) likewise, on faces that have points. Returns what each face of the slave has: no
  /// nodes where all are prescribed, or where there are no points.
  /// @param paired_points and points: the same ones, face by face; and so are segment edges
  template <int dim>
  std::vector<PressureNodes>
  set_pressure_functions(const Elasticity<dim>               &elasticity,
                         const ContactMethod                 &method,
                         Basis                                basis,
                         const BoundaryFaces<dim>            &slave,
                         const std::vector<PairedPoint<dim>> &paired_points,
                         const std::vector<PairedPoint<dim>> &paired_edge_points,
                         std::vector<ContactPoint<dim>>      &points,
                         std::vector<EdgeContactPoint<dim>>  &edge_points);
} // namespace Signorini
