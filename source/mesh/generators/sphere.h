// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh/generators/named_surface.h"

namespace Signorini
{
  /// A ball or a part of it. Boundaries: sphere, and the cuts top, symmetry_x, symmetry_y of
  /// ball_parts.
  class SphereMesh : public MeshGenerator<3>
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
    double           radius = 1;
    std::string      part   = "full";
  };
} // namespace Signorini
