// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/elasticity.h"

#include <memory>
#include <vector>

namespace Signorini
{
  /// The estimated error of a small-strain solution by the neglected terms of finite strain
  /// (doc/theory, 6.7).
  struct DeformationChange
  {
    double work   = 0; ///< int |(P - sigma) : Grad u| dV over int |sigma : Grad u| dV; at most 1
    double strain = 0; ///< largest norm of the linear strain
    double largest_rotation = 0; ///< largest angle of the linear rotation [radian]
  };

  /// Estimate the error of the small-strain solution u. P is the first Piola-Kirchhoff stress of
  /// the given laws for the same displacement, sigma the stress at small strain. Both squares of
  /// strains and squares of rotations, which sigma takes for strains, contribute. Cells that are
  /// inverted count as completely wrong. Where bodies bend, rotations of order t contribute t^2
  /// over the strain, which is more than the error of the deflection: the result is an upper bound
  /// rather than an estimate. Collective.
  /// @param elasticity at small strain
  /// @param laws one for each material id
  template <int dim>
  DeformationChange
  deformation_change(const Elasticity<dim>                                     &elasticity,
                     const std::vector<std::shared_ptr<const ConstitutiveLaw>> &laws,
                     const LA::Vector                                          &u);
} // namespace Signorini
