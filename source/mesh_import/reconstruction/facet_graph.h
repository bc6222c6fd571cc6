// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/grid/tria_description.h>

#include <vector>

namespace Signorini
{
  /// Boundary faces as facets of something that may be curved: which of them go on in each other at
  /// a small angle.
  template <int dim>
  class FacetGraph
  {
  public:
    struct Neighbour
    {
      unsigned int face;
      double       sagitta; ///< of a chord as long as a facet; 0 if they are in a plane
    };

    /// @param faces with vertices in deal.II's order
    /// @param inserted vertices between others, where facets were divided. Refers to all three.
    FacetGraph(const std::vector<dealii::CellData<dim - 1>> &faces,
               const std::vector<dealii::Point<dim>>        &vertices,
               const std::vector<bool>                      &inserted);

    const std::vector<Neighbour> &
    neighbours(const unsigned int face) const
    {
      return of_faces[face];
    }

    /// Of unit length and any sign.
    const dealii::Tensor<1, dim> &
    normal(const unsigned int face) const
    {
      return normals[face];
    }

    /// The largest of these faces and their neighbours.
    double
    sagitta(const std::vector<unsigned int> &some) const;

    const std::vector<dealii::CellData<dim - 1>> &faces;
    const std::vector<dealii::Point<dim>>        &vertices;
    const std::vector<bool>                      &inserted;

  private:
    void
    join(const std::vector<unsigned int> &rim, unsigned int a, unsigned int b);

    std::vector<dealii::Tensor<1, dim>> normals;
    std::vector<dealii::Point<dim>>     centers;
    std::vector<std::vector<Neighbour>> of_faces;
  };
} // namespace Signorini
