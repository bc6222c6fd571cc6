// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh/generators/named_surface.h"
#include <signorini/parameters/definitions.h>

namespace Signorini
{
  /// A rectangle or cuboid along the axes, with cells that may grow geometrically along each axis.
  /// Boundaries: left, right (low and high x); 2D: bottom, top (y); 3D: front, back (y), bottom,
  /// top (z).
  template <int dim>
  class BoxMesh : public MeshGenerator<dim>
  {
  public:
    BoxMesh();

    void
    declare(Section &section) override;

    std::vector<std::string>
    boundaries() const override;

    CoarseMesh<dim>
    generate() const override
    {
      return generate_merged(0);
    }

    /// Cells are merged in three-dimensional boxes of more than a thousand equal cells.
    unsigned int
    possible_merges() const override;

    CoarseMesh<dim>
    generate_merged(unsigned int merges) const override;

    bool
    curved() const override
    {
      return false;
    }

  private:
    std::vector<NamedSurface<dim>>
    surfaces() const;

    Formula                   corners;
    std::vector<unsigned int> subdivisions;
    std::vector<double>       grading;

    /// The points of `corners`.
    dealii::Point<dim> low, high;
  };
} // namespace Signorini
