// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/face_parameter.h"

#include <deal.II/fe/fe.h>

#include <vector>

namespace Signorini
{
  /// @return the nodes on a face of a cell, as numbers of the scalar element.
  /// @param scalar the element
  /// @param face number of the face
  template <int dim>
  std::vector<unsigned int>
  nodes_of_face(const dealii::FiniteElement<dim> &scalar, const unsigned int face)
  {
    std::vector<unsigned int> nodes;
    for (unsigned int i = 0; i < scalar.n_dofs_per_cell(); ++i)
      if (is_on_face<dim>(scalar.reference_cell(), face, scalar.unit_support_point(i)))
        nodes.push_back(i);
    return nodes;
  }
} // namespace Signorini
