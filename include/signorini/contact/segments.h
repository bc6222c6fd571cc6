#pragma once

#include <signorini/contact/face_patch.h>

#include <deal.II/base/quadrature.h>

#include <vector>

namespace Signorini
{
  /// A quadrature point of a contact segment: of the part of a slave face that lies opposite to one
  /// master face.
  template <int dim>
  struct SegmentPoint
  {
    dealii::Point<dim - 1> slave, master; ///< parameters on the two faces
    double                 weight;        ///< area of the slave face that it stands for
  };

  /// Contact segments, thesis 3.2: the exact intersection of a slave face with the projection of a
  /// master face, cut into simplices with a quadrature rule on each. Integrands that have a kink
  /// where master faces meet are smooth on each segment.
  ///
  /// Both faces are split along the nodes of their geometry into multilinear facets. Facets meet in
  /// the plane (2D: line) through the center of the slave's facet, normal to its mean normal, into
  /// which both are projected along that normal (Puso and Laursen, CMAME 193 (2004) 601-629). A
  /// point of the intersection goes back to each facet's own parameters, and is weighted with the
  /// Jacobian of the true slave face there: if master faces cover the slave face, then the weights
  /// of all segments sum up to its area also where it is curved.
  ///
  /// @param rule on the reference interval (2D) or triangle (3D)
  /// @returns nothing where the faces do not overlap; does not ask how far apart they are or
  /// whether they face each other.
  template <int dim>
  std::vector<SegmentPoint<dim>>
  segment_points(const FacePatch<dim>              &slave,
                 const FacePatch<dim>              &master,
                 const dealii::Quadrature<dim - 1> &rule);

  /// The box of all that lies within `reach` of a slave face along the normals of its facets, on
  /// both sides: master faces outside have no segment with it.
  template <int dim>
  dealii::BoundingBox<dim>
  extruded_box(const FacePatch<dim> &slave, double reach);
} // namespace Signorini
