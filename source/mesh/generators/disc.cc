// SPDX-License-Identifier: Apache-2.0
#include "geometry/manifolds.h"
#include "mesh/generators/circle_part.h"
#include "mesh/generators/generators.h"
#include "mesh/generators/named_surface.h"
#include "mesh/generators/octants.h"
#include <signorini/parameters/section.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

namespace Signorini
{
  using namespace dealii;

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



  void
  DiscMesh::declare(Section &section)
  {
    section.add("Center", center, "center of the disc [length]");
    section.add("Radius", radius, "radius [length]", positive);
    section.add_choice(
      "Part",
      part,
      circle_part_names(),
      "of the whole; boundaries: `arc`, and the cuts at the height of the center, `top` of a lower "
      "part and `bottom` of an upper one, and `symmetry` at its x; "
      "half: the upper one, quarter: the upper right one");
    if (!section.reading())
      return;
    check_size(section, "Radius", radius, radius);
    check_size(section, "Center", radius, center.norm() + radius);
  }



  std::vector<NamedSurface<2>>
  DiscMesh::surfaces() const
  {
    std::vector<NamedSurface<2>> result{sphere("arc", center, radius)};
    result[0].manifold      = std::make_shared<RoundManifold<2>>(center);
    const CirclePart sector = circle_part(part);
    if (sector.is_cut_at_y())
      result.push_back(plane<2>(sector.is_upper() ? "bottom" : "top", 1, center[1], radius));
    if (sector.is_cut_at_x())
      result.push_back(plane<2>("symmetry", 0, center[0], radius));
    return result;
  }



  std::vector<std::string>
  DiscMesh::boundaries() const
  {
    return names_of(surfaces());
  }



  // A quarter of a disc of radius one is rotated and merged, then scaled and shifted.
  CoarseMesh<2>
  DiscMesh::generate() const
  {
    const CirclePart          sector = circle_part(part);
    std::vector<CopyRotation> turns;
    for (unsigned int quarter = 0; quarter < sector.quarters; ++quarter)
      turns.push_back({(sector.first + quarter) % 4});

    Triangulation<2> quarter, triangulation;
    GridGenerator::quarter_hyper_ball(quarter);
    merge_copies(quarter, turns, triangulation);
    GridTools::scale(radius, triangulation);
    GridTools::shift(center, triangulation);
    return with_boundaries(triangulation, surfaces());
  }



  std::unique_ptr<MeshGenerator<2>>
  make_disc()
  {
    return std::make_unique<DiscMesh>();
  }
} // namespace Signorini
