// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/search/face_patch.h"

#include <deal.II/base/quadrature.h>

#include <array>
#include <optional>
#include <vector>

namespace Signorini
{
  /// A quadrature point of a contact segment, the part of a slave face that lies opposite to one
  /// master face.
  template <int dim>
  struct SegmentPoint
  {
    dealii::Point<dim - 1> slave, master; ///< parameters on the two faces
    double                 weight;        ///< quadrature weight times area of the slave face
  };

  /// A quadrature point of a segment edge, where a contact segment ends because its master face
  /// ends. As the master moves, so does the edge.
  template <int dim>
  struct SegmentEdgePoint
    : public SegmentPoint<dim> ///< weight: area that an outward step of 1 adds
  {
    dealii::Tensor<1, dim> outward; ///< unit, in the mean plane of the slave's facet
    unsigned int           side;    ///< of the master face, see ends_of_side()
  };

  /// Quadrature rules, with positive weights, on the pieces that segments are cut into.
  template <int dim>
  struct SegmentRule
  {
    /// @param n the degree is at least 2 n - 1, on quadrilaterals in each parameter; for n = 2 on
    /// triangles it is 2, with three points, which integrates products of two bilinear functions as
    /// exactly as the constant pressure of a patch test needs
    explicit SegmentRule(unsigned int n);

    dealii::Quadrature<dim - 1> on_simplices, on_squares;
  };

  /// A (multi)linear piece of a face between neighbouring nodes of its geometry, of the shape of
  /// the face; corners lexicographic.
  template <int dim>
  struct Facet
  {
    std::vector<dealii::Point<dim>> corners;
    /// The parameter of the face at the first corner, and its derivatives by those of the facet.
    dealii::Point<dim - 1>                          origin;
    std::array<dealii::Tensor<1, dim - 1>, dim - 1> edges;
    dealii::Point<dim>                              center;
    std::array<dealii::Tensor<1, dim>, dim - 1>     axes; ///< orthonormal, in its mean plane

    /// The parameter of the face from that of the facet, moved into the face, since rounding may
    /// lead outside. @param shape reference cell of the face; @param s parameter of the facet
    dealii::Point<dim - 1>
    parameter_of_face(const dealii::ReferenceCell &shape, const dealii::Point<dim - 1> &s) const;

    /// The side of the face on which a side of the facet lies; none if that is inside. Both are
    /// numbered as in ends_of_side().
    std::optional<unsigned int>
    side_of_face(const dealii::ReferenceCell &shape, unsigned int side) const;
  };

  /// A face with its multilinear facets, computed once for all segments of the face: one for a face
  /// that hardly differs from that of its corners.
  template <int dim>
  struct FacetedFace
  {
    FacetedFace() = default;
    FacetedFace(const FacePatch<dim> &patch);

    /// The bounding box of all points within `search_radius` along the normals of the facets, on
    /// both sides. Master faces outside of it have no segment with this slave face.
    dealii::BoundingBox<dim>
    extruded_box(double search_radius) const;

    FacePatch<dim>          patch;
    std::vector<Facet<dim>> facets;
  };

  /// Contact segments (doc/theory, 3.3): the exact intersection of a slave face with the projection
  /// of a master face, cut into pieces with a quadrature rule on each. Integrands that have a
  /// kink where master faces meet are smooth on each segment.
  ///
  /// Both faces are split along the nodes of their geometry into multilinear facets, unless one is
  /// as good. Facets meet in
  /// the plane (2D: line) through the center of the slave's facet, normal to its mean normal, into
  /// which both are projected along that normal (Puso and Laursen, CMAME 193 (2004) 601-629). A
  /// point of the intersection goes back to each facet's own parameters, and is weighted with the
  /// Jacobian of the true slave face there: if master faces cover the slave face, then the weights
  /// of all segments sum up to its area also where it is curved.
  ///
  /// @return the points of all segments; none where the faces do not overlap. The distance of the
  /// faces and their orientation are not checked.
  template <int dim>
  std::vector<SegmentPoint<dim>>
  segment_points(const FacetedFace<dim> &slave,
                 const FacetedFace<dim> &master,
                 const SegmentRule<dim> &rule);

  /// Quadrature points on the edges of the segments that segment_points() makes.
  /// @param n_points number of Gauss points on each straight piece of an edge; 2D: there is one
  /// point
  template <int dim>
  std::vector<SegmentEdgePoint<dim>>
  segment_edge_points(const FacetedFace<dim> &slave,
                      const FacetedFace<dim> &master,
                      unsigned int            n_points);
} // namespace Signorini
