// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/contact/obstacles/obstacle.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <array>

namespace Signorini
{
  /// Triangles in space whose vertices go around anticlockwise, seen from outside.
  struct Triangles
  {
    std::vector<dealii::Point<3>>            vertices;
    std::vector<std::array<unsigned int, 3>> corners; ///< indices into `vertices`
  };

  /// Signed distance from a surface of triangles. The sign is that of the angle-weighted
  /// pseudo-normal at the closest point (Baerentzen and Aanaes 2005), which is right at edges and
  /// vertices too. The surface may have a rim, where the triangle there gives the sign.
  class TriangleSurface
  {
  public:
    /// Throws SceneError with the position if more than two triangles meet in an edge, or two of
    /// opposite orientation, or if there are no triangles. Triangles without area are left out.
    explicit TriangleSurface(const Triangles &triangles);

    /// The signed distance [length] and the unit normal at the closest point of the surface.
    /// Curvature is zero.
    ObstaclePoint<3>
    closest(const dealii::Point<3> &x) const;

    /// The bounding box of the surface.
    dealii::BoundingBox<3>
    extent() const
    {
      return box;
    }

  private:
    using Vector = dealii::Tensor<1, 3>;
    using Entry  = std::pair<dealii::BoundingBox<3>, unsigned int>;

    /// A point of a triangle, and what of the triangle it lies on.
    struct TrianglePoint
    {
      dealii::Point<3> point;
      Vector           normal; ///< pseudo-normal there
      bool             inside; ///< neither on an edge nor on a vertex
    };

    /// Set the pseudonormals of vertices: sums of the normals of their triangles, weighted with the
    /// angles there.
    void
    add_vertex_normals();
    /// Set the pseudonormals of edges: sums of the normals of their triangles. Throws SceneError if
    /// the orientation of the surface is not consistent.
    void
    add_edge_normals();
    /// The closest point of a triangle.
    TrianglePoint
    foot(const dealii::Point<3> &x, unsigned int triangle) const;

    std::vector<dealii::Point<3>>            vertices;
    std::vector<std::array<unsigned int, 3>> corners;
    std::vector<Vector>                      face_normals, vertex_normals;
    std::vector<std::array<Vector, 3>>       edge_normals; ///< of the edges from corner i to i+1
    dealii::BoundingBox<3>                   box;
    dealii::RTree<Entry>                     tree;
  };

  /// Read an STL file, as text or binary. Vertices at equal positions are merged. The normals in
  /// the file are ignored: the order of the vertices determines the outer side. Throws SceneError
  /// with the name of the file.
  Triangles
  read_stl(const std::string &file_name);

  /// Read the surface elements of a mesh file, or those and the faces of one of its sets.
  /// Quadrilaterals are divided, and elements of second order through their mid-side nodes: a
  /// triangle into four. Outside is where their corners go around anticlockwise. Throws SceneError
  /// with the name of the file.
  /// @param surface name of the set in any case; empty: all surface elements
  Triangles
  read_mesh_surface(const std::string &file_name, const std::string &surface);
} // namespace Signorini
