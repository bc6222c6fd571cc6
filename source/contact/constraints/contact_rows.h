// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/interface/surface.h"
#include "contact/interface/surface_points.h"
#include <signorini/contact/methods/method.h>

#include <vector>

namespace Signorini
{
  /// The contribution of an integration point to a row of the gap operator: row r has the share
  /// psi_r(q) w_q of the area of point q (doc/theory, (3.3)).
  struct Share
  {
    dealii::types::global_dof_index row;
    /// Share of the area of the point [length^(dim-1)]; negative for dual functions where they are.
    double weight;
  };

  /// The rows of the gap operator and how integration points contribute to them. With
  /// Sampling::quadrature_points each point has a row of its own; with Sampling::nodes a slave node
  /// collects the points around it, weighted by its multiplier shape function.
  struct ContactRows
  {
    /// Rows of this rank; one contiguous range.
    dealii::IndexSet owned;
    /// The owned rows, and rows of other ranks to which points of this rank contribute.
    dealii::IndexSet writable;
    /// The shares of the points of this rank: [pair][point][share].
    std::vector<std::vector<std::vector<Share>>> shares;
    /// Contributions of the rows' pressures to segment edge points: [pair][edge point].
    std::vector<std::vector<std::vector<Share>>> edge_point_shares;
    /// The pair of each owned row.
    std::vector<unsigned int> pair;
    /// The first degree of freedom of the node of each owned row; empty with rows at quadrature
    /// points.
    std::vector<dealii::types::global_dof_index> node;
    /// The positions of rows on the slave faces of this rank that have points.
    std::vector<SurfacePoints> places;
  };

  /// Number the rows of the gap operator and distribute the areas of points to them. Collective.
  /// @param surfaces one for each pair, with multiplier shape functions
  template <int dim>
  ContactRows
  make_contact_rows(const Elasticity<dim>                  &elasticity,
                    const std::vector<ContactSurface<dim>> &surfaces,
                    Sampling                                sampling);
} // namespace Signorini
