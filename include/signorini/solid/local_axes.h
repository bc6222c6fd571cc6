// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <string>
#include <vector>

namespace Signorini
{
  class Section;

  /// The kinds of coordinates to which components of vectors may refer.
  enum class Coordinates
  {
    cartesian,  ///< the global axes
    rotated,    ///< x', y', z' of other directions
    cylindrical ///< r, theta, z about an axis
  };

  /// The axes to which the components of a vector refer, at each point of the reference
  /// configuration.
  template <int dim>
  struct LocalAxes
  {
    Coordinates coordinates = Coordinates::cartesian;
    /// Rotated: the direction of x' and, in space, a vector in the plane of x' and y'. Cylindrical:
    /// a point of the axis and, in space, its direction.
    std::vector<dealii::Point<dim>> definition;

    /// Declare the keys. Throws SceneError through the section.
    /// @param of what has the components
    void
    declare(Section &section, const std::string &of);

    /// True if the components are those of the global axes.
    bool
    are_global() const
    {
      return coordinates == Coordinates::cartesian;
    }

    /// The unit vectors of the axes at x, row by row. On the axis of cylindrical coordinates the
    /// first dim - 1 of them are zero vectors.
    dealii::Tensor<2, dim>
    at(const dealii::Point<dim> &x) const;

    /// The global components of a vector at x; not numbers where an axis is not defined along which
    /// the vector has a component.
    dealii::Tensor<1, dim>
    to_global(const dealii::Tensor<1, dim> &components, const dealii::Point<dim> &x) const;
  };
} // namespace Signorini
