// SPDX-License-Identifier: Apache-2.0
#include "solid/resultant.h"
#include <signorini/contact/master_image.h>
#include <signorini/parameters/section.h>

#include <deal.II/physics/transformations.h>

#include <string>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  void
  MasterImage<dim>::declare(Section &section)
  {
    section.add(
      "Master rotation",
      rotation,
      "the slave meets the master rotated by this angle about the Master axis, and its displacement "
      "rotated likewise: cyclic symmetry, with 360/N for N sectors [degree]");
    section.add("Master axis",
                axis,
                dim == 3 ?
                  "a point of the axis of the rotation; its direction. Default: 0,0,0; 0,0,1" :
                  "the centre of the rotation. Default: 0,0");
    section.add("Master shift",
                shift,
                "the slave meets the master shifted by this vector: periodicity [length]");
    if (!section.reading())
      return;
    if (!axis.empty() && !turns())
      section.fail("Master axis", "has no effect without Master rotation; remove it, or set that");
    if (!axis.empty() && axis.size() != dim - 1)
      section.fail("Master axis",
                   dim == 3 ? "needs a point and a direction: x,y,z; dx,dy,dz" :
                              "needs one point: x,y");
    if (dim == 3 && axis.size() == 2 && axis[1].norm() == 0)
      section.fail("Master axis", "the zero vector has no direction");
  }



  template <int dim>
  Tensor<2, dim>
  MasterImage<dim>::turn() const
  {
    const double angle = rotation * numbers::PI / 180;
    if constexpr (dim == 2)
      return Physics::Transformations::Rotations::rotation_matrix_2d(angle);
    else
      {
        const Tensor<1, 3> along = axis.empty() ? Point<3>(0, 0, 1) : axis[1];
        return Physics::Transformations::Rotations::rotation_matrix_3d(along / along.norm(), angle);
      }
  }



  template <int dim>
  Point<dim>
  MasterImage<dim>::of(const Point<dim> &x) const
  {
    const Point<dim> center = axis.empty() ? Point<dim>() : axis[0];
    return center + turn() * (x - center) + shift;
  }



  template <int dim>
  Point<dim>
  MasterImage<dim>::origin_of(const Point<dim> &x) const
  {
    const Point<dim> center = axis.empty() ? Point<dim>() : axis[0];
    return center + at_master(x - shift - center);
  }



  template <int dim>
  Tensor<1, dim>
  MasterImage<dim>::at_master(const Tensor<1, dim> &v) const
  {
    return v * turn();
  }



  // A moment M about the origin is that about the image of the origin, o, and o x F; the first part
  // rotates back to one about the origin itself.
  template <int dim>
  Tensor<1, 3>
  MasterImage<dim>::moment_at_master(const Tensor<1, 3> &moment, const Tensor<1, dim> &force) const
  {
    const Tensor<1, 3> about_image = moment - moment_of(of(Point<dim>()), force);
    if constexpr (dim == 2)
      return about_image;
    else
      return about_image * turn();
  }



  template struct MasterImage<2>;
  template struct MasterImage<3>;
} // namespace Signorini
