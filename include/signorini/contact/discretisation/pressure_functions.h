#pragma once

#include <signorini/contact/discretisation/surface.h>
#include <signorini/contact/geometry/boundary_faces.h>

namespace Signorini
{
  /// False for a node of a slave face whose displacement along the normal is prescribed, or nearly
  /// so, and for one of degree 2 on the axis, whose function has no area (int N r dr = 0).
  /// @param first degree of freedom of the node
  template <int dim>
  bool
  carries_pressure(const Elasticity<dim>          &elasticity,
                   dealii::types::global_dof_index first,
                   unsigned int                    degree,
                   const FacePatch<dim>           &face,
                   const dealii::Point<dim - 1>   &xi);

  /// Sets the functions of the pressure at the points of a surface (`shape` and `interpolation`).
  /// Nodes that cannot move along the normal carry none if the pressure is an unknown of its own;
  /// their neighbours take over. Returns the number of faces that can carry none at all.
  /// Those of seams (`shape`) likewise, on faces that have points.
  /// @param paired_points and points: the same ones, face by face; and so are seams
  template <int dim>
  unsigned int
  set_pressure_functions(const Elasticity<dim>               &elasticity,
                         const ContactMethod                 &method,
                         Basis                                basis,
                         const BoundaryFaces<dim>            &slave,
                         const std::vector<PairedPoint<dim>> &paired_points,
                         const std::vector<PairedPoint<dim>> &paired_seams,
                         std::vector<ContactPoint<dim>>      &points,
                         std::vector<Seam<dim>>              &seams);
} // namespace Signorini
