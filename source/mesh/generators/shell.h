// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh/generators/named_surface.h"

namespace Signorini
{
  /// The space between two spheres or a part of it (2D: the ring does it). Boundaries: inner,
  /// outer, and the cuts top, symmetry_x, symmetry_y of ball_parts.
  class ShellMesh : public MeshGenerator<3>
  {
  public:
    void
    declare(Section &section) override;

    std::vector<std::string>
    boundaries() const override;

    CoarseMesh<3>
    generate() const override;

    bool
    curved() const override
    {
      return true;
    }

  private:
    std::vector<NamedSurface<3>>
    surfaces() const;

    dealii::Point<3> center;
    double           inner_radius = 0.5, outer_radius = 1;
    std::string      part         = "full";
    unsigned int     cells_around = 1, cells_through = 1;
  };
} // namespace Signorini
