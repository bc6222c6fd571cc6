// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh/generators/named_surface.h"

namespace Signorini
{
  /// The space between two circles, or a part of it; in 3D a tube along z. Boundaries: inner,
  /// outer; symmetry_x, symmetry_y, where it is cut at the x or the y of the center; 3D: bottom,
  /// top.
  template <int dim>
  class RingMesh : public MeshGenerator<dim>
  {
  public:
    void
    declare(Section &section) override;

    std::vector<std::string>
    boundaries() const override;

    CoarseMesh<dim>
    generate() const override;

    bool
    curved() const override
    {
      return true;
    }

  private:
    std::vector<NamedSurface<dim>>
    surfaces() const;

    NamedSurface<dim>
    round_surface(const std::string &name, double radius) const;

    dealii::Point<dim> center;
    double             inner_radius = 0.5, outer_radius = 1, height = 1;
    unsigned int       cells_around = 8, cells_through = 1, layers = 1;
    std::string        part = "full";
  };
} // namespace Signorini
