// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/grid/tria_description.h>

#include <vector>

namespace Signorini
{
  /// The boundary faces of a mesh as facets of a surface that may be curved. Two faces are
  /// neighbours in this graph if they share a rim (2D: a vertex, 3D: an edge) at which the surface
  /// bends by no more than 35 degrees, i.e. if they may approximate one smooth surface.
  template <int dim>
  class FacetGraph
  {
  public:
    /// A face that continues another one smoothly.
    struct Neighbour
    {
      /// Index into `faces`.
      unsigned int face;
      /// The sagitta [length] of a circular arc over a facet, estimated from the angle at the
      /// common rim and the distance of the two centres; 0 if both facets are in one plane.
      double sagitta;
    };

    /// Build the graph. It refers to all three arguments, which must live as long as it does.
    /// @param faces the boundary faces, with vertices in deal.II's order
    /// @param vertices the vertices of the mesh
    /// @param inserted one entry for each vertex: whether it was inserted between others where
    /// facets were divided, and therefore need not be on the surface
    FacetGraph(const std::vector<dealii::CellData<dim - 1>> &faces,
               const std::vector<dealii::Point<dim>>        &vertices,
               const std::vector<bool>                      &inserted);

    /// @return the faces that continue this one smoothly, in no particular order.
    /// @param face index into `faces`
    const std::vector<Neighbour> &
    neighbours(const unsigned int face) const
    {
      return of_faces[face];
    }

    /// @return the normal of a face, of unit length; its sign (outward or inward) is arbitrary.
    /// @param face index into `faces`
    const dealii::Tensor<1, dim> &
    normal(const unsigned int face) const
    {
      return normals[face];
    }

    /// @return the largest sagitta [length] at the rims of these faces; 0 if they have no
    /// neighbours, or are in one plane with all of them.
    /// @param some indices into `faces`
    double
    sagitta(const std::vector<unsigned int> &some) const;

    /// The arguments of the constructor.
    const std::vector<dealii::CellData<dim - 1>> &faces;
    const std::vector<dealii::Point<dim>>        &vertices;
    const std::vector<bool>                      &inserted;

  private:
    /// Make two faces neighbours if the surface bends by at most 35 degrees at their common rim.
    void
    join(const std::vector<unsigned int> &rim, unsigned int a, unsigned int b);

    std::vector<dealii::Tensor<1, dim>> normals;
    std::vector<dealii::Point<dim>>     centers;
    std::vector<std::vector<Neighbour>> of_faces;
  };
} // namespace Signorini
