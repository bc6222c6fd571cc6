// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh/generators/named_surface.h"

namespace Signorini
{
  /// A disc or a part of it. Boundaries: arc; top of a lower part, or bottom of an upper one, where
  /// it is cut at the height of the center; symmetry, where it is cut at the x of the center.
  class DiscMesh : public MeshGenerator<2>
  {
  public:
    void
    declare(Section &section) override;

    std::vector<std::string>
    boundaries() const override;

    CoarseMesh<2>
    generate() const override;

    bool
    curved() const override
    {
      return true;
    }

  private:
    std::vector<NamedSurface<2>>
    surfaces() const;

    dealii::Point<2> center;
    double           radius = 1;
    std::string      part   = "full";
  };
} // namespace Signorini
