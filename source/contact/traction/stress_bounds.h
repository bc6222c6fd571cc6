// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/search/boundary_faces.h"
#include "contact/traction/normal_stress.h"

#include <utility>
#include <vector>

namespace Signorini
{
  /// Bounds of the stress on faces, see NormalStress::bound(), computed on demand and
  /// stored. They are multiplied by the number of faces of the boundary that a cell has, since
  /// these share its strain energy (doc/theory, 2.7).
  template <int dim>
  class StressBounds
  {
  public:
    /// @param with_slip see NormalStress::bound()
    StressBounds(const BoundaryFaces<dim> &boundary, const bool with_slip)
      : faces(boundary.faces)
      , with_slip(with_slip)
      , bounds(faces.size(), -1.)
    {}

    /// @param stress on the cell of face i
    double
    operator()(NormalStress<dim> &stress, const unsigned int i)
    {
      if (bounds[i] < 0)
        bounds[i] = stress.bound(faces[i].second, with_slip) * faces_of_cell(i);
      return bounds[i];
    }

  private:
    /// The number of faces of the cell of face i; they are neighbours in the list.
    unsigned int
    faces_of_cell(const unsigned int i) const
    {
      unsigned int first = i, last = i + 1;
      while (first > 0 && faces[first - 1].first == faces[i].first)
        --first;
      while (last < faces.size() && faces[last].first == faces[i].first)
        ++last;
      return last - first;
    }

    const std::vector<std::pair<CellIterator<dim>, unsigned int>> faces;
    const bool                                                    with_slip;
    std::vector<double>                                           bounds;
  };
} // namespace Signorini
