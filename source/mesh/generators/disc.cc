#include <signorini/mesh/generators/disc.h>
#include <signorini/mesh/generators/octants.h>
#include <signorini/parameters/section.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

namespace Signorini
{
  using namespace dealii;

  void
  DiscMesh::declare(Section &section)
  {
    section.add("Center", center, "center of the disc [length]");
    section.add("Radius", radius, "radius [length]", positive);
    section.add_choice(
      "Part",
      part,
      {"full", "lower half", "lower right quarter"},
      "of the whole; boundaries: arc, and the cuts top (at the height of the center) "
      "and symmetry (at its x)");
  }



  std::vector<NamedSurface<2>>
  DiscMesh::surfaces() const
  {
    std::vector<NamedSurface<2>> result{sphere("arc", center, radius)};
    result[0].manifold = std::make_shared<SphericalManifold<2>>(center);
    if (part != "full")
      result.push_back(plane<2>("top", 1, center[1], radius));
    if (part == "lower right quarter")
      result.push_back(plane<2>("symmetry", 0, center[0], radius));
    return result;
  }



  std::vector<std::string>
  DiscMesh::boundaries() const
  {
    return names_of(surfaces());
  }



  CoarseMesh<2>
  DiscMesh::generate() const
  {
    std::vector<Turn> turns{{3}};
    if (part != "lower right quarter")
      turns.push_back({2});
    if (part == "full")
      turns.insert(turns.end(), {{0}, {1}});

    Triangulation<2> quarter, triangulation;
    GridGenerator::quarter_hyper_ball(quarter);
    join_copies(quarter, turns, triangulation);
    GridTools::scale(radius, triangulation);
    GridTools::shift(center, triangulation);
    return with_boundaries(triangulation, surfaces());
  }
} // namespace Signorini
