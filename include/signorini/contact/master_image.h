// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <vector>

namespace Signorini
{
  class Section;

  /// The image of the master surface that the slave of a pair meets: the master itself, or where
  /// it is in the next sector of a cyclic model or in the next cell of a periodic one. The image of
  /// a point x is Q (x - c) + c + d, with a rotation Q about an axis through c and a shift d, and
  /// the displacement of the image is Q u.
  template <int dim>
  struct MasterImage
  {
    double rotation = 0; ///< about the axis, counterclockwise [degree]
    /// A point of the axis and, in space, its direction; not given: the origin and z.
    std::vector<dealii::Point<dim>> axis;
    dealii::Point<dim>              shift; ///< d [length]

    /// Declare the keys. Throws SceneError through the section.
    void
    declare(Section &section);

    /// True if the image is the master itself.
    bool
    is_master() const
    {
      return !turns() && shift.norm() == 0;
    }

    /// True if the image is rotated.
    bool
    turns() const
    {
      return rotation != 0;
    }

    /// The rotation Q.
    dealii::Tensor<2, dim>
    turn() const;

    /// The image of a point.
    dealii::Point<dim>
    of(const dealii::Point<dim> &x) const;

    /// The point whose image is x.
    dealii::Point<dim>
    origin_of(const dealii::Point<dim> &x) const;

    /// Q^T v: a direction or force at the image, as it is at the master.
    dealii::Tensor<1, dim>
    at_master(const dealii::Tensor<1, dim> &v) const;

    /// A moment about the origin at the image, as it is at the master; with one component in 2D.
    /// @param force at the image
    dealii::Tensor<1, 3>
    moment_at_master(const dealii::Tensor<1, 3> &moment, const dealii::Tensor<1, dim> &force) const;
  };
} // namespace Signorini
