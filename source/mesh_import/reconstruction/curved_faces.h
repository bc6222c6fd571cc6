// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/manifolds.h"
#include "mesh_import/reconstruction/facet_graph.h"

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/grid/manifold.h>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace Signorini
{
  /// A circle, sphere, cylinder or cone on which points lie, r(h) = radius + slope h with the
  /// height h along the axis.
  template <int dim>
  struct FittedSurface
  {
    /// Centre of the circle or sphere, or a point of the axis.
    dealii::Point<dim> center;
    /// Unit vector; zero for a circle or sphere.
    dealii::Tensor<1, dim> axis;
    /// Radius [length]; of a cone in the plane through the centre.
    double radius;
    /// For a cone the change of the radius per length along the axis; otherwise 0.
    double slope;

    /// @return the closest point of the surface; on a cone the one at the same height, which is
    /// close to it if p is close to the surface. NaN if p is the centre or on the axis.
    /// @param p any other point
    dealii::Point<dim>
    closest(const dealii::Point<dim> &p) const;

    /// @return the distance [length] of a point from the surface, on a cone at constant height.
    /// @param p the point
    double
    distance(const dealii::Point<dim> &p) const
    {
      return p.distance(closest(p));
    }

    /// @return a deal.II manifold on which new points of refined cells are placed.
    std::unique_ptr<dealii::Manifold<dim>>
    manifold() const;

    /// @return a text for messages, such as "a cylinder of radius 2 about the axis through (0, 0,
    /// 0) along (0, 0, 1)".
    std::string
    description() const;
  };

  /// Fit a surface by least squares.
  /// @param points that it shall pass
  /// @param normals of facets between the points, with signs such that neighbours agree, for a
  /// first guess of the axis (3D)
  /// @param tolerance largest distance [length] of any point
  /// @return the simplest surface (sphere, cylinder, cone, in this order) that is no farther than
  /// the tolerance from all points; none if there is none
  template <int dim>
  std::optional<FittedSurface<dim>>
  fit_surface(const std::vector<dealii::Point<dim>>     &points,
              const std::vector<dealii::Tensor<1, dim>> &normals,
              double                                     tolerance);

  /// Facets that approximate a circle, sphere, cylinder or cone.
  template <int dim>
  struct RoundFaces
  {
    FittedSurface<dim> surface;
    /// Indices into the list of faces.
    std::vector<unsigned int> faces;
    /// Largest distance [length] of the facets from the surface, estimated from the angles between
    /// them.
    double sagitta;
  };

  /// The result of find_round_faces() for all boundary faces of a mesh.
  template <int dim>
  struct Facets
  {
    /// The surfaces that were recognised; no face is in two of them.
    std::vector<RoundFaces<dim>> round;
    /// For each face an estimate of its distance [length] from a smooth surface through its corners
    /// and those of the faces next to it; 0 for faces in `round`.
    std::vector<double> sagitta;
  };

  /// Recognise circles, spheres, cylinders and cones in a boundary that a CAD program or mesh
  /// generator has approximated by facets: these meet at small angles, and all their corners are on
  /// the surface. Such surfaces may continue smoothly as others, as fillets do. Regions grow from
  /// seeds of a few facets, as long as corners are on the fitted surface up to a hundredth of the
  /// sagitta of the facets.
  /// @param graph the boundary faces with their neighbours
  template <int dim>
  Facets<dim>
  find_round_faces(const FacetGraph<dim> &graph);

  /// Find facets that may be meant as a curved surface: the boundary bends at two sides of them at
  /// least, by half a degree or more and no more than at a rim of the graph. Facets in one plane
  /// count as one, and not at all if they have a corner inside: a plane that several elements
  /// divide is a plane, and what bends beside it is an edge. Vertices that were inserted are no
  /// corners.
  /// @param graph the boundary faces with their neighbours
  /// @return for each face the largest of these angles [degrees]; 0 if it is not among them
  template <int dim>
  std::vector<double>
  find_bent_facets(const FacetGraph<dim> &graph);

  /// A facet that is replaced by a part of a smooth surface.
  template <int dim>
  struct SmoothFace
  {
    /// Index into the list of faces.
    unsigned int face;
    /// The curved edges, from which CurvedFace interpolates the surface.
    typename CurvedFace<dim>::Edges edges;
    /// Estimated distance [length] of the curved face from the true surface.
    double uncertainty;
  };

  /// The result of find_smooth_faces().
  template <int dim>
  struct SmoothFaces
  {
    /// The facets that become curved.
    std::vector<SmoothFace<dim>> faces;
    /// All vertices of the mesh; those that were inserted by dividing cells have been moved onto
    /// the reconstructed surface.
    std::vector<dealii::Point<dim>> vertices;
  };

  /// Reconstruct facets whose corners are on any smooth surface, such as a spline. At each corner a
  /// polynomial of third (or second) degree is fitted to the corners around. It determines the
  /// normal where its deviation from them is at most a quarter of the sagitta of the facets. Edges
  /// become cubic curves with the tangents that follow from these normals, so that the distance
  /// from the surface is of order four in the mesh size (in the middle of faces that are far from
  /// parallelograms, a hundredth of the sagitta). Kinks and jumps of the curvature cannot be
  /// fitted: the facets near them are kept.
  /// @param graph the boundary faces with their neighbours
  /// @param known for each face whether its surface is known already; such faces are not changed
  /// @return the curved faces and the moved vertices
  template <int dim>
  SmoothFaces<dim>
  find_smooth_faces(const FacetGraph<dim> &graph, const std::vector<bool> &known);

  /// A smooth surface near a point, the origin: a polynomial height over a plane, fitted to points
  /// around.
  template <int dim>
  class LocalSurface
  {
  public:
    /// Unit normal of the surface at the origin.
    dealii::Tensor<1, dim> normal;
    /// Signed distance [length] of the surface from the origin along the normal; 0 if it passes
    /// through the origin.
    double offset = 0;
    /// Root mean square of the distances [length] of the points from the surface.
    double deviation = 0;
    /// Whether there were enough points to determine the surface.
    bool fits = true;

    LocalSurface() = default;

    /// Fit by weighted least squares, in which near points have more weight. The polynomial is of
    /// third degree, or of second where there are few points.
    /// @param arms the points, as vectors from the origin
    /// @param up a unit vector that is about normal to the surface
    /// @param through whether the surface passes through the origin exactly
    LocalSurface(const std::vector<dealii::Tensor<1, dim>> &arms,
                 const dealii::Tensor<1, dim>              &up,
                 bool                                       through);

    /// @return the plane through the origin with this normal.
    /// @param normal a unit vector
    static LocalSurface
    plane(const dealii::Tensor<1, dim> &normal);

    /// @return the distance [length] of a point from the surface, measured along `up`, which is
    /// about normal to it.
    /// @param arm the point, as a vector from the origin
    double
    distance(const dealii::Tensor<1, dim> &arm) const;

    /// A number of points that exceeds the number of coefficients of the cubic polynomial
    /// sufficiently for the deviation to be an estimate of the error.
    static constexpr unsigned int enough = dim == 2 ? 4 : 18;

  private:
    std::array<double, dim - 1>
    place_of(const dealii::Tensor<1, dim> &arm) const;

    dealii::Tensor<1, dim> up;
    /// The axes of the plane, each divided by the extent of the points along it.
    std::array<dealii::Tensor<1, dim>, dim - 1> axes;
    unsigned int                                degree = 0;
    /// Coefficients of the monomials in the coordinates along `axes`; they have the unit of a
    /// length.
    std::vector<double> coefficients;
  };
} // namespace Signorini
