// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/constraints/contact_rows.h"
#include "contact/constraints/gap_operator.h"
#include "contact/interface/surface.h"
#include "contact/search/boundary_faces.h"
#include "contact/search/vectors_across.h"

#include <array>
#include <vector>

namespace Signorini
{
  /// The frames of the slave surface at paired points. @param slave the faces that points count
  template <int dim>
  std::vector<SurfaceFrame<dim>>
  surface_frames(const BoundaryFaces<dim> &slave, const std::vector<PairedPoint<dim>> &points);

  /// The tangent vectors vectors_across(N) of the slave in the reference configuration, convected
  /// to the current one: they are rotated by R of the polar decomposition P F = R U, where P
  /// projects onto the plane normal to the contact normal.
  template <int dim>
  struct ConvectedFrame
  {
    std::array<dealii::Tensor<1, dim>, dim - 1> vectors; ///< orthonormal, across the contact normal
    double                                      stretch; ///< trace of U

    /// @param normal N, outward unit normal of the slave at rest
    /// @param F see SurfaceFrame
    /// @param direction unit contact normal, about opposite to that of the slave
    ConvectedFrame(const dealii::Tensor<1, dim> &normal,
                   const dealii::Tensor<2, dim> &F,
                   const dealii::Tensor<1, dim> &direction);
  };

  /// The tangents along which the slip of each row of the gap operator is measured.
  ///
  /// In the reference configuration they are dim - 1 unit vectors perpendicular to the mean normal
  /// of the slave around the row, the same on any number of ranks. At an integration point they are
  /// rotated with the normal of the surface by the smallest rotation; in displaced configurations
  /// they also rotate with the material of the slave, see ConvectedFrame. So the components of a
  /// traction along these tangents keep their meaning in a rigid motion, and the points of a row
  /// have a smooth field of directions on curved surfaces (doc/theory, 3.7 and 5.6).
  template <int dim>
  class Tangents
  {
  public:
    using Frame = std::array<dealii::Tensor<1, dim>, dim - 1>;

    /// Average the normals of the slave around each row. Keeps a reference to the rows. Collective.
    Tangents(const ContactRows                      &rows,
             const std::vector<ContactSurface<dim>> &surfaces,
             MPI_Comm                                comm);

    /// The reference tangents of a row that this rank owns or contributes to.
    Frame
    at_rest(dealii::types::global_dof_index row) const;

    /// The tangents of a row, rotated to the surface at one of its points.
    /// @param frame of the point
    /// @param direction unit contact normal there
    Frame
    at(dealii::types::global_dof_index row,
       const SurfaceFrame<dim>        &frame,
       const dealii::Tensor<1, dim>   &direction) const;

    /// The slip of the present load step at a point along the tangents of a row [length], in
    /// displaced configurations: the change of t.(x - y) since the start of the load step, where x
    /// is the slave's point, y its present projection as a material point, and t the tangents. It
    /// is invariant under a common rigid motion of both surfaces.
    dealii::Tensor<1, dim - 1>
    slip(dealii::types::global_dof_index row,
         const SurfaceFrame<dim>        &frame,
         const dealii::Tensor<1, dim>   &direction) const;

  private:
    /// The mean reference normal of a row, of unit length.
    dealii::Tensor<1, dim>
    normal(dealii::types::global_dof_index row) const;
    /// The tangents of a row at a point whose surface has the deformation F, see at().
    Frame
    convected(dealii::types::global_dof_index row,
              const dealii::Tensor<1, dim>   &normal_at_rest,
              const dealii::Tensor<2, dim>   &F,
              const dealii::Tensor<1, dim>   &direction) const;

    std::vector<LA::Vector> normals; ///< component by component, with ghosts; not of unit length
  };

  /// Remove the slip across planes of symmetry from the rows of slave nodes on them, where supports
  /// hold the slave and the master there in the same direction. There is none between the surfaces,
  /// and no traction in that direction, by symmetry. But of a multiplier at such a node, whose own
  /// motion is prescribed, only the motion of master nodes beside the plane would be left in the
  /// weighted slip, which would hold these. Collective.
  /// @param tangents of the rows
  /// @param contact with B, rows of the slip and offsets; changed
  template <int dim>
  void
  remove_slip_across_symmetry_planes(const Elasticity<dim> &elasticity,
                                     const Tangents<dim>   &tangents,
                                     GapOperator           &contact);

  /// Let the slip of slave nodes that supports hold or move along the surface, within 17 degrees,
  /// depend on the support alone. The tangents of a curved surface differ from its direction by the
  /// mesh, so that a small part of the free motion across the surface would count as slip: traction
  /// there, which hardly moves the body, would not be determined. Collective.
  /// @param tangents of the rows @param is_free 0 where supports prescribe the degree of freedom
  /// @param contact with B and rows of the slip, which are changed
  template <int dim>
  void
  align_slip_with_supports(const Elasticity<dim> &elasticity,
                           const Tangents<dim>   &tangents,
                           const LA::Vector      &is_free,
                           GapOperator           &contact);
} // namespace Signorini
