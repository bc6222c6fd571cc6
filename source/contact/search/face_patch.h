// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/search/bytes.h"
#include "geometry/face_parameter.h"

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/boost_adaptors/bounding_box.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/grid/tria.h>

#include <array>
#include <functional>
#include <vector>

namespace Signorini
{
  /// Position and derivatives of a face at one point.
  template <int dim>
  struct FaceGeometry
  {
    dealii::Point<dim> position;
    /// The tangents d x / d xi_i [length]; not of unit length.
    std::array<dealii::Tensor<1, dim>, dim - 1> tangents;
    /// Second derivatives d2 x / d xi_i d xi_j [length], symmetric.
    std::array<std::array<dealii::Tensor<1, dim>, dim - 1>, dim - 1> curvatures;
  };



  /// The geometry of one face: x(xi) = sum_i L_i(xi) X_i with Lagrange polynomials of degree k and
  /// equidistant nodes, in lexicographic order, on the line or square [0,1]^(dim-1) or on the
  /// reference triangle. It equals the face of a mapping of the same degree, and does not refer to
  /// a mesh, so that it can be tested and sent to other ranks by itself.
  template <int dim>
  class FacePatch
  {
  public:
    using Parameter = dealii::Point<dim - 1>;

    FacePatch() = default;

    /// @param nodes (k+1)^(dim-1) points, or (k+1)(k+2)/2 of a triangle; @param outward the sign
    /// that makes the parametric normal (2D: rotate x_xi clockwise; 3D: x_xi cross x_eta) point out
    /// of the body.
    FacePatch(unsigned int degree, const std::vector<dealii::Point<dim>> &nodes, double outward);

    /// The geometry of a boundary face of a cell under a mapping of that degree. The parameter xi
    /// is the point on the reference face in the sense of QProjector (face in standard
    /// orientation), so unit_point() maps it to the reference cell.
    FacePatch(const dealii::Mapping<dim>                                      &mapping,
              unsigned int                                                     degree,
              const typename dealii::Triangulation<dim>::active_cell_iterator &cell,
              unsigned int                                                     face);

    /// The face after a rigid motion of its points.
    FacePatch
    moved(const std::function<dealii::Point<dim>(const dealii::Point<dim> &)> &motion) const;

    /// Position and derivatives of a point.
    /// @param n_derivatives the highest order that is needed, 0 to 2; others may be zero
    FaceGeometry<dim>
    at(const Parameter &xi, unsigned int n_derivatives) const;

    /// The position x(xi) of a point of the face (doc/theory, (3.1)).
    dealii::Point<dim>
    position(const Parameter &xi) const;

    /// The tangents d x / d xi_i; not of unit length.
    std::array<dealii::Tensor<1, dim>, dim - 1>
    tangents(const Parameter &xi) const;

    /// Second derivatives d2 x / d xi_i d xi_j.
    std::array<std::array<dealii::Tensor<1, dim>, dim - 1>, dim - 1>
    curvatures(const Parameter &xi) const;

    /// Outward unit normal.
    dealii::Tensor<1, dim>
    normal(const Parameter &xi) const;

    /// Area of the face per area of the parameters.
    double
    jacobian(const Parameter &xi) const;

    /// The reference cell of the face: a line, a quadrilateral or a triangle.
    const dealii::ReferenceCell &
    reference_cell() const
    {
      return shape;
    }

    /// The parameter in the middle of the face.
    Parameter
    middle() const
    {
      return shape.barycenter<dim - 1>();
    }

    /// The degree k of the geometry; 1 if the face is multilinear, whatever degree it was made
    /// with, since fewer nodes then suffice.
    unsigned int
    get_degree() const;

    /// The sign of the parametric normal, see the constructor.
    double
    get_outward() const
    {
      return outward;
    }

    /// A box that contains the face (inflated where the face is curved).
    const dealii::BoundingBox<dim> &
    box() const;

    /// Largest distance of two nodes: the length that tolerances are measured against.
    double
    diameter() const;

    /// Estimate of the largest norm of the second derivatives, rather too large than too small.
    double
    second_derivative_bound() const;

    /// Average of the nodes: an identity of the face that does not depend on ranks or numbering.
    dealii::Point<dim>
    center() const;

    template <class Archive>
    void
    serialize(Archive &ar, const unsigned int)
    {
      ar &degree &shape;
      serialize_bytes(ar, nodes);
      ar &outward &bounds &size &largest_curvature &piece;
    }

    /// Number of the connected piece of the mesh that the face belongs to, see Mesh::piece(); set
    /// for faces in the reference configuration. Faces of two pieces are no neighbours, however
    /// near they are.
    unsigned int piece = 0;

  private:
    /// Compute size, bounding box and bound of the second derivatives from the nodes.
    void
    measure();

    unsigned int                    degree = 1;
    dealii::ReferenceCell           shape;
    std::vector<dealii::Point<dim>> nodes;
    double                          outward = 1;
    dealii::BoundingBox<dim>        bounds;
    double                          size = 0, largest_curvature = 0;
  };
} // namespace Signorini
