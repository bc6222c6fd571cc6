// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/elasticity.h"

#include <memory>
#include <vector>

namespace Signorini
{
  /// The error of a small-strain solution: what it neglects of finite strain.
  struct DeformationChange
  {
    double work   = 0; ///< int |(P - sigma) : Grad u| dV over int |sigma : Grad u| dV; at most 1
    double strain = 0; ///< largest norm of the linear strain
    double largest_rotation = 0; ///< largest angle of the linear rotation [radian]
  };

  /// At the solution u, whose stress is sigma at small strain; P is the first Piola-Kirchhoff
  /// stress of the same displacement by these laws. Both the squares of strains and those of
  /// rotations, which are strains to sigma, make it. Cells that are folded count as wholly wrong.
  /// Where bodies bend, rotations of order t make the share t^2 over the strain, which is more than
  /// what the deflection lacks: an upper bound rather than an estimate. Collective.
  /// @param elasticity of small strain, without thermal expansion
  /// @param laws one a body
  template <int dim>
  DeformationChange
  deformation_change(const Elasticity<dim>                                     &elasticity,
                     const std::vector<std::shared_ptr<const ConstitutiveLaw>> &laws,
                     const LA::Vector                                          &u);
} // namespace Signorini
