// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/interface/surface.h"
#include "linear_algebra/types.h"

#include <vector>

namespace Signorini
{
  /// Read access to some elements of a distributed vector, which are fetched once in the
  /// constructor.
  class VectorValues
  {
  public:
    /// Collective. @param u without ghosts @param indices in any order, repeated or not
    VectorValues(const LA::Vector &u, std::vector<dealii::types::global_dof_index> indices);

    /// The element of one of the indices given to the constructor.
    double
    operator()(dealii::types::global_dof_index index) const;

    /// The product row . u; all columns must be among the indices.
    double
    operator()(const SparseRow &row) const;

  private:
    std::vector<dealii::types::global_dof_index> indices; ///< sorted
    std::vector<double>                          values;
  };

  /// The increments row() . u of the normal gaps of points due to a displacement [length].
  /// Collective.
  /// @param u without ghosts
  /// @return one value for each point, positive if the gap opens
  template <int dim>
  std::vector<double>
  gap_increments(const std::vector<const ContactPoint<dim> *> &points, const LA::Vector &u);

  /// @return the relative displacements u^S - u^M of points [length], in the directions of the
  /// slave. Collective.
  /// @param points of a surface
  /// @param frames of these points, with the motion of obstacles
  /// @param u without ghosts
  template <int dim>
  std::vector<dealii::Tensor<1, dim>>
  relative_displacements(const std::vector<const ContactPoint<dim> *> &points,
                         const std::vector<const SurfaceFrame<dim> *> &frames,
                         const LA::Vector                             &u);
} // namespace Signorini
