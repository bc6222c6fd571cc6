// SPDX-License-Identifier: Apache-2.0
#include "geometry/manifolds.h"
#include "geometry/memory.h"
#include "mesh/generators/circle_part.h"
#include "mesh/generators/generators.h"
#include "mesh/generators/named_surface.h"
#include <signorini/parameters/section.h>

#include <array>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

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



  namespace
  {
    /// @return cosine and sine of the angle of vertex j, exact at multiples of right angles, so
    /// that cuts are plane.
    std::array<double, 2>
    direction(const CirclePart &sector, const unsigned int j, const unsigned int n)
    {
      const unsigned int    steps = sector.quarters * j; // n of them make a right angle
      const double          angle = numbers::PI_2 * (steps % n) / n;
      std::array<double, 2> d{{steps % n ? std::cos(angle) : 1., steps % n ? std::sin(angle) : 0.}};
      for (unsigned int turn = 0; turn < sector.first + steps / n; ++turn)
        d = {{-d[1], d[0]}};
      return d;
    }



    /// A structured grid, numbered through the thickness, then around, then along the height.
    template <int dim>
    struct Grid
    {
      /// Numbers of cells; one layer in 2D.
      unsigned int through, around, layers;
      bool         closed;

      /// @return the number of a vertex; in a closed ring the last one around is the first.
      unsigned int
      vertex(const unsigned int i, const unsigned int j, const unsigned int k) const
      {
        const unsigned int n_around = closed ? around : around + 1;
        return (k * n_around + j % n_around) * (through + 1) + i;
      }

      /// @return the positions of all vertices, in the order of their numbers.
      template <typename PointAt>
      std::vector<Point<dim>>
      vertices(const PointAt &point_at) const
      {
        std::vector<Point<dim>> result;
        for (unsigned int k = 0; k <= (dim == 3 ? layers : 0); ++k)
          for (unsigned int j = 0; j <= (closed ? around - 1 : around); ++j)
            for (unsigned int i = 0; i <= through; ++i)
              result.push_back(point_at(i, j, k));
        return result;
      }

      /// @return all cells.
      std::vector<CellData<dim>>
      cells() const
      {
        std::vector<CellData<dim>> result;
        for (unsigned int k = 0; k < layers; ++k)
          for (unsigned int j = 0; j < around; ++j)
            for (unsigned int i = 0; i < through; ++i)
              {
                result.emplace_back();
                for (unsigned int v = 0; v < result.back().vertices.size(); ++v)
                  result.back().vertices[v] = vertex(i + v % 2, j + (v / 2) % 2, k + v / 4);
              }
        return result;
      }
    };
  } // namespace



  template <int dim>
  void
  RingMesh<dim>::declare(Section &section)
  {
    section.add("Center",
                center,
                dim == 2 ? "center of the circles [length]" :
                           "lower end of the axis, which is parallel to z [length]");
    section.add("Inner radius", inner_radius, "radius of the boundary `inner` [length]", positive);
    section.add("Outer radius", outer_radius, "radius of the boundary `outer` [length]", positive);
    section.add_choice(
      "Part",
      part,
      circle_part_names(),
      "of the whole, cut along x = cx at `symmetry_x` and along y = cy at `symmetry_y`; half: the "
      "upper one, quarter: the upper right one");
    section.add("Cells around", cells_around, "coarse cells along the arc of the part", {1});
    section.add("Cells through", cells_through, "coarse cells through the thickness", {1});
    if (dim == 3)
      {
        section.add("Height", height, "from `bottom` to `top` [length]", positive);
        section.add("Layers", layers, "coarse cells along the height", {1});
        if (section.reading())
          check_size(section, "Height", height, std::abs(center[dim - 1]) + height);
      }
    if (!section.reading())
      return;
    if (inner_radius >= outer_radius)
      section.fail("Inner radius", "must be smaller than the outer one");
    check_size(section, "Inner radius", inner_radius, outer_radius);
    check_size(section, "Center", inner_radius, center.norm() + outer_radius);
    check_number_of_cells(section,
                          "Cells around",
                          {cells_around, cells_through, dim == 3 ? layers : 1});
    if (cells_around < circle_part(part).quarters)
      section.fail("Cells around", "there must be at least one cell in 90 degrees");
  }



  template <int dim>
  NamedSurface<dim>
  RingMesh<dim>::round_surface(const std::string &name, const double radius) const
  {
    // A cylinder is a circle in the coordinates x, y.
    const auto flat   = [](const Point<dim> &p) { return Point<2>(p[0], p[1]); };
    const auto circle = sphere(name, flat(center), radius);
    return {name, [=](const Point<dim> &p) { return circle.contains(flat(p)); }, nullptr};
  }



  template <int dim>
  std::vector<NamedSurface<dim>>
  RingMesh<dim>::surfaces() const
  {
    std::vector<NamedSurface<dim>> result{round_surface("inner", inner_radius),
                                          round_surface("outer", outer_radius)};
    if (circle_part(part).is_cut_at_x())
      result.push_back(plane<dim>("symmetry_x", 0, center[0], outer_radius));
    if (circle_part(part).is_cut_at_y())
      result.push_back(plane<dim>("symmetry_y", 1, center[1], outer_radius));
    if (dim == 3)
      {
        result.push_back(plane<dim>("bottom", dim - 1, center[dim - 1], height));
        result.push_back(plane<dim>("top", dim - 1, center[dim - 1] + height, height));
      }
    return result;
  }



  template <int dim>
  std::vector<std::string>
  RingMesh<dim>::boundaries() const
  {
    return names_of(surfaces());
  }



  // Cells are created from the structured grid; the manifold of the whole mesh is cylindrical (2D:
  // polar).
  template <int dim>
  CoarseMesh<dim>
  RingMesh<dim>::generate() const
  {
    const CirclePart sector = circle_part(part);
    const Grid<dim>  grid{cells_through, cells_around, dim == 3 ? layers : 1, part == "full"};
    // Radii grow linearly through the thickness, angles around, heights along z.
    const auto point_at = [&](const unsigned int i, const unsigned int j, const unsigned int k) {
      const double r = inner_radius + (outer_radius - inner_radius) * i / cells_through;
      const auto   d = direction(sector, j, cells_around);
      Point<dim>   p = center;
      p[0] += r * d[0];
      p[1] += r * d[1];
      if (dim == 3)
        p[dim - 1] += height * k / layers;
      return p;
    };

    Triangulation<dim> triangulation;
    triangulation.create_triangulation(grid.vertices(point_at), grid.cells(), SubCellData());
    triangulation.set_all_manifold_ids(0);
    Tensor<1, dim> axis;
    if (dim == 3)
      axis[dim - 1] = 1;
    triangulation.set_manifold(0, RoundManifold<dim>(center, axis));
    return with_boundaries(triangulation, surfaces());
  }



  template <int dim>
  std::unique_ptr<MeshGenerator<dim>>
  make_ring()
  {
    return std::make_unique<RingMesh<dim>>();
  }



  template std::unique_ptr<MeshGenerator<2>>
  make_ring();
  template std::unique_ptr<MeshGenerator<3>>
  make_ring();
} // namespace Signorini
