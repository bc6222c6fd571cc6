// SPDX-License-Identifier: Apache-2.0
#include "geometry/manifolds.h"
#include "geometry/memory.h"
#include "mesh/generators/generators.h"
#include "mesh/generators/named_surface.h"
#include "mesh/generators/octants.h"
#include <signorini/parameters/section.h>

#include <deal.II/grid/grid_tools.h>

#include <array>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

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



  namespace
  {
    /// The octant of a shell: squares on the three faces of the cube [0,n]^3 that do not contain
    /// the origin, projected radially onto the spheres such that squares along an edge of the cube
    /// become equal arcs.
    class OctantOfShell
    {
    public:
      OctantOfShell(const unsigned int n, const std::vector<double> &radii)
        : n(n)
        , radii(radii)
      {
        for (unsigned int face = 0; face < 3; ++face)
          for (unsigned int i = 0; i < n; ++i)
            for (unsigned int j = 0; j < n; ++j)
              for (unsigned int layer = 0; layer + 1 < radii.size(); ++layer)
                add_cell(face, i, j, layer);
      }

      /// Create the triangulation.
      void
      create(Triangulation<3> &triangulation) const
      {
        triangulation.create_triangulation(vertices, cells, SubCellData());
      }

    private:
      /// Append the cell over square (i, j) of a face, in a layer.
      void
      add_cell(const unsigned int face,
               const unsigned int i,
               const unsigned int j,
               const unsigned int layer)
      {
        cells.emplace_back();
        for (unsigned int v = 0; v < 8; ++v)
          {
            std::array<unsigned int, 3> place;
            place[face]              = n;
            place[(face + 1) % 3]    = i + v % 2;
            place[(face + 2) % 3]    = j + (v / 2) % 2;
            cells.back().vertices[v] = vertex(place, layer + v / 4);
          }
      }

      /// @return the number of a vertex, which is created at the first call, so that faces of the
      /// cube share it.
      unsigned int
      vertex(const std::array<unsigned int, 3> &place, const unsigned int layer)
      {
        const unsigned int next    = vertices.size();
        const auto [entry, is_new] = numbers.insert({{place, layer}, next});
        if (is_new)
          {
            Point<3> p;
            for (unsigned int d = 0; d < 3; ++d)
              p[d] = place[d] == n ? 1 : std::tan(dealii::numbers::PI_4 * place[d] / n);
            vertices.push_back(p * (radii[layer] / p.norm()));
          }
        return entry->second;
      }

      const unsigned int        n;
      const std::vector<double> radii;

      std::vector<Point<3>>                                                        vertices;
      std::vector<CellData<3>>                                                     cells;
      std::map<std::pair<std::array<unsigned int, 3>, unsigned int>, unsigned int> numbers;
    };
  } // namespace



  void
  ShellMesh::declare(Section &section)
  {
    section.add("Center", center, "center (cx, cy, cz) of the spheres [length]");
    section.add("Inner radius", inner_radius, "radius of the boundary `inner` [length]", positive);
    section.add("Outer radius", outer_radius, "radius of the boundary `outer` [length]", positive);
    section.add_choice("Part", part, ball_parts, ball_part_help);
    section.add("Cells along 45 degrees", cells_around, "coarse cells per 45 degrees of arc", {1});
    section.add("Cells through", cells_through, "coarse cells through the thickness", {1});
    if (!section.reading())
      return;
    if (inner_radius >= outer_radius)
      section.fail("Inner radius", "must be smaller than the outer one");
    check_size(section, "Inner radius", inner_radius, outer_radius);
    check_size(section, "Center", inner_radius, center.norm() + outer_radius);
    check_number_of_cells(section,
                          "Cells along 45 degrees",
                          {3, cells_around, cells_around, cells_through});
  }



  std::vector<NamedSurface<3>>
  ShellMesh::surfaces() const
  {
    std::vector<NamedSurface<3>> result{sphere("inner", center, inner_radius),
                                        sphere("outer", center, outer_radius)};
    for (const auto &cut : cuts_of_ball_part(part, center, outer_radius))
      result.push_back(cut);
    return result;
  }



  std::vector<std::string>
  ShellMesh::boundaries() const
  {
    return names_of(surfaces());
  }



  CoarseMesh<3>
  ShellMesh::generate() const
  {
    std::vector<double> radii;
    for (unsigned int layer = 0; layer <= cells_through; ++layer)
      radii.push_back((inner_radius + (outer_radius - inner_radius) * layer / cells_through) /
                      outer_radius);

    Triangulation<3> octant, triangulation;
    OctantOfShell(cells_around, radii).create(octant);
    merge_copies(octant, turns_of_ball_part(part), triangulation);
    GridTools::scale(outer_radius, triangulation);
    GridTools::shift(center, triangulation);
    triangulation.set_all_manifold_ids(0);
    triangulation.set_manifold(0, RoundManifold<3>(center));
    return with_boundaries(triangulation, surfaces());
  }



  std::unique_ptr<MeshGenerator<3>>
  make_shell()
  {
    return std::make_unique<ShellMesh>();
  }
} // namespace Signorini
