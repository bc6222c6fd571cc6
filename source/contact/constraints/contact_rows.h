// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/interface/surface.h"
#include "contact/interface/surface_points.h"
#include <signorini/contact/methods/method.h>

#include <vector>

namespace Signorini
{
  /// The contribution of an integration point to a row of the gap operator.
  struct Share
  {
    dealii::types::global_dof_index row;
    double                          weight;
  };

  /// The rows of the gap operator and how integration points contribute to them. With
  /// Sampling::quadrature_points each point has a row of its own; with Sampling::nodes a slave node
  /// collects the points around it, weighted by its multiplier shape function.
  struct ContactRows
  {
    dealii::IndexSet owned;
    dealii::IndexSet writable; ///< owned, and those that points of this rank contribute to
    std::vector<std::vector<std::vector<Share>>> shares; ///< [pair][point]
    /// Contributions of the rows' pressures to segment edge points: [pair][edge point].
    std::vector<std::vector<std::vector<Share>>> edge_point_shares;
    std::vector<unsigned int>                    pair;
    std::vector<dealii::types::global_dof_index> node;
    std::vector<SurfacePoints> places; ///< of the faces of this rank that have points
  };

  template <int dim>
  ContactRows
  make_contact_rows(const Elasticity<dim>                  &elasticity,
                    const std::vector<ContactSurface<dim>> &surfaces,
                    Sampling                                sampling);
} // namespace Signorini
