// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/interface/surface.h"
#include "contact/interface/surface_points.h"
#include <signorini/contact/methods/method.h>

#include <vector>

namespace Signorini
{
  /// A share of a contact point that goes to a row of the gap operator.
  struct Share
  {
    dealii::types::global_dof_index row;
    double                          weight;
  };

  /// Which rows there are, and which shares of each contact point they take.
  struct ContactRows
  {
    dealii::IndexSet owned;
    dealii::IndexSet writable; ///< owned, and those that points of this rank contribute to
    std::vector<std::vector<std::vector<Share>>> shares; ///< [pair][point]
    /// Those that segment edges have in the pressures of rows: [pair][segment edge].
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
