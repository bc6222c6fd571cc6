// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/constraints/contact_rows.h"
#include "contact/constraints/tangents.h"

#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace Signorini
{
  /// The rows of B and S to which some points of one slave face contribute, as dense matrices:
  /// adding them at once costs a fraction of adding them point by point.
  struct FaceMatrix
  {
    std::vector<dealii::types::global_dof_index> rows, columns;
    dealii::FullMatrix<double>                   displacement;
    dealii::FullMatrix<double>                   stress; ///< empty if points have none
    std::vector<dealii::FullMatrix<double>>      slip;   ///< along each tangent
  };

  /// The matrices of all contact points of this rank, multiplied by the points' areas.
  /// @param tangents along which the slip is measured; null: the method does not use it
  /// @param all_components true: keep columns of all displacement components, since inclined
  /// supports may eliminate some in terms of others; false: only components along which normals are
  /// not zero
  template <int dim>
  std::vector<FaceMatrix>
  face_matrices(const ContactRows                      &rows,
                const std::vector<ContactSurface<dim>> &surfaces,
                Sampling                                sampling,
                const Tangents<dim>                    *tangents,
                bool                                    all_components);
} // namespace Signorini
