// SPDX-License-Identifier: Apache-2.0
#include "geometry/manifolds.h"
#include "mesh/generators/generators.h"
#include "mesh/generators/named_surface.h"
#include "mesh/generators/octants.h"
#include <signorini/parameters/section.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

namespace Signorini
{
  using namespace dealii;

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



  void
  SphereMesh::declare(Section &section)
  {
    section.add("Center", center, "center (cx, cy, cz) of the ball [length]");
    section.add("Radius", radius, "radius [length]", positive);
    section.add_choice("Part", part, ball_parts, ball_part_help + "; boundary `sphere`");
    if (!section.reading())
      return;
    check_size(section, "Radius", radius, radius);
    check_size(section, "Center", radius, center.norm() + radius);
  }



  // The sphere itself has a manifold; cuts are planes through the center.
  std::vector<NamedSurface<3>>
  SphereMesh::surfaces() const
  {
    std::vector<NamedSurface<3>> result{sphere("sphere", center, radius)};
    result[0].manifold = std::make_shared<RoundManifold<3>>(center);
    for (const auto &cut : cuts_of_ball_part(part, center, radius))
      result.push_back(cut);
    return result;
  }



  std::vector<std::string>
  SphereMesh::boundaries() const
  {
    return names_of(surfaces());
  }



  // Rotated copies of one octant of the unit ball, scaled and moved.
  CoarseMesh<3>
  SphereMesh::generate() const
  {
    Triangulation<3> octant, triangulation;
    GridGenerator::quarter_hyper_ball(octant);
    merge_copies(octant, turns_of_ball_part(part), triangulation);
    GridTools::scale(radius, triangulation);
    GridTools::shift(center, triangulation);
    return with_boundaries(triangulation, surfaces());
  }



  std::unique_ptr<MeshGenerator<3>>
  make_sphere()
  {
    return std::make_unique<SphereMesh>();
  }
} // namespace Signorini
