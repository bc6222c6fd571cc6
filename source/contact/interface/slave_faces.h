// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/constraints/pressure_functions.h"
#include "contact/search/boundary_faces.h"

#include <utility>
#include <vector>

namespace Signorini
{
  /// The nodes of the slave faces that have contact points; the entries of other faces are empty.
  /// @param functions result of set_pressure_functions()
  template <int dim>
  std::vector<SlaveFace<dim>>
  slave_faces(const Elasticity<dim>                &elasticity,
              const BoundaryFaces<dim>             &slave,
              const std::vector<ContactPoint<dim>> &points,
              const std::vector<PressureNodes>     &functions);

  template <int dim>
  bool
  any_dirichlet_node(const std::vector<SlaveFace<dim>> &faces);

  /// (shape functions, area) at Gauss points of all slave faces in the reference configuration, see
  /// ContactSurface::full_face_shapes.
  template <int dim>
  std::vector<std::pair<SparseRow, double>>
  full_face_shape_functions(const Elasticity<dim> &elasticity, const BoundaryFaces<dim> &slave);
} // namespace Signorini
