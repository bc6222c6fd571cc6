// SPDX-License-Identifier: Apache-2.0
#include "mesh/generators/octants.h"

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <deque>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// @return a rotated point; rotations by right angles are exact.
    template <int dim>
    Point<dim>
    rotated(Point<dim> p, const CopyRotation &turn)
    {
      for (unsigned int i = 0; i < turn.quarters; ++i)
        {
          const double x = p[0];
          p[0]           = -p[1];
          p[1]           = x;
        }
      if (turn.upside_down)
        for (unsigned int d = 1; d < dim; ++d)
          p[d] = -p[d];
      return p;
    }
  } // namespace



  // Manifolds are removed, since they would be those of the first copy.
  template <int dim>
  void
  merge_copies(const Triangulation<dim>        &first,
               const std::vector<CopyRotation> &turns,
               Triangulation<dim>              &whole)
  {
    std::deque<Triangulation<dim>>          copies;
    std::vector<const Triangulation<dim> *> pointers;
    for (const CopyRotation &turn : turns)
      {
        copies.emplace_back();
        copies.back().copy_triangulation(first);
        GridTools::transform([&](const Point<dim> &p) { return rotated(p, turn); }, copies.back());
        pointers.push_back(&copies.back());
      }
    GridGenerator::merge_triangulations(pointers, whole);
    whole.set_all_manifold_ids(numbers::flat_manifold_id);
    whole.reset_all_manifolds();
  }



  std::vector<CopyRotation>
  turns_of_ball_part(const std::string &part)
  {
    // Three quarter rotations followed by half a rotation about x map the octant x, y, z >= 0 to x,
    // y >= 0, z <= 0.
    std::vector<CopyRotation> turns{{3, true}};
    if (part != "lower quarter")
      for (unsigned int quarters = 0; quarters < 3; ++quarters)
        turns.push_back({quarters, true});
    if (part == "full")
      for (unsigned int quarters = 0; quarters < 4; ++quarters)
        turns.push_back({quarters, false});
    return turns;
  }



  std::vector<NamedSurface<3>>
  cuts_of_ball_part(const std::string &part, const Point<3> &center, const double radius)
  {
    std::vector<NamedSurface<3>> cuts;
    if (part != "full")
      cuts.push_back(plane<3>("top", 2, center[2], radius));
    if (part == "lower quarter")
      {
        cuts.push_back(plane<3>("symmetry_x", 0, center[0], radius));
        cuts.push_back(plane<3>("symmetry_y", 1, center[1], radius));
      }
    return cuts;
  }



  template void
  merge_copies(const Triangulation<2> &, const std::vector<CopyRotation> &, Triangulation<2> &);
  template void
  merge_copies(const Triangulation<3> &, const std::vector<CopyRotation> &, Triangulation<3> &);
} // namespace Signorini
