// SPDX-License-Identifier: Apache-2.0
#include "geometry/memory.h"
#include "mesh/generators/generators.h"
#include "mesh/generators/named_surface.h"
#include <signorini/parameters/definitions.h>
#include <signorini/parameters/section.h>

#include <deal.II/grid/grid_generator.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  /// A rectangle or cuboid along the axes, with cells that may grow geometrically along each axis.
  /// Boundaries: left, right (low and high x); 2D: bottom, top (y); 3D: front, back (y), bottom,
  /// top (z).
  template <int dim>
  class BoxMesh : public MeshGenerator<dim>
  {
  public:
    BoxMesh();

    void
    declare(Section &section) override;

    std::vector<std::string>
    boundaries() const override;

    CoarseMesh<dim>
    generate() const override
    {
      return generate_merged(0);
    }

    /// Cells are merged in three-dimensional boxes of more than a thousand equal cells.
    unsigned int
    possible_merges() const override;

    CoarseMesh<dim>
    generate_merged(unsigned int merges) const override;

    bool
    curved() const override
    {
      return false;
    }

  private:
    std::vector<NamedSurface<dim>>
    surfaces() const;

    Formula                   corners;
    std::vector<unsigned int> subdivisions;
    std::vector<double>       grading;

    /// The points of `corners`.
    dealii::Point<dim> low, high;
  };



  namespace
  {
    /// @return the point with these coordinates. Throws SceneError if there are not dim of them.
    template <int dim>
    Point<dim>
    point_from(const std::vector<double> &coordinates)
    {
      if (coordinates.size() != dim)
        throw SceneError("each corner must have " + std::to_string(dim) + " coordinates");
      Point<dim> p;
      for (unsigned int d = 0; d < dim; ++d)
        p[d] = coordinates[d];
      return p;
    }



    /// @return the corners of a text "x,y : x,y". Throws SceneError without the position in the
    /// scene.
    template <int dim>
    std::array<Point<dim>, 2>
    corners_from(const Formula &text)
    {
      const std::vector<std::string> parts = split(text.text, ':');
      if (parts.size() != 2)
        throw SceneError("must be two points, separated by a colon");
      std::array<Point<dim>, 2> corners;
      for (unsigned int i = 0; i < 2; ++i)
        {
          std::vector<double> coordinates;
          from_text({parts[i], text.definitions}, coordinates);
          corners[i] = point_from<dim>(coordinates);
        }
      for (unsigned int d = 0; d < dim; ++d)
        if (!(corners[0][d] < corners[1][d]))
          throw SceneError("each coordinate of the second corner must be the larger one");
      return corners;
    }



    /// @return n steps that add up to a length, each q times the one before it, the last one
    /// `ratio` times the first.
    std::vector<double>
    steps(const double length, const unsigned int n, const double ratio)
    {
      const double        q = n > 1 ? std::pow(ratio, 1. / (n - 1)) : 1;
      std::vector<double> result(n, 1.);
      double              sum = 1;
      for (unsigned int i = 1; i < n; ++i)
        sum += result[i] = q * result[i - 1];
      for (double &step : result)
        step *= length / sum;
      return result;
    }
  } // namespace



  template <int dim>
  BoxMesh<dim>::BoxMesh()
    : corners(dim == 2 ? "0,0 : 1,1" : "0,0,0 : 1,1,1")
    , subdivisions(dim, 1)
    , grading(dim, 1.)
  {
    for (unsigned int d = 0; d < dim; ++d)
      high[d] = 1;
  }



  template <int dim>
  void
  BoxMesh<dim>::declare(Section &section)
  {
    const std::string an_axis = "one number an axis";
    section.add("Corners",
                corners,
                "lowest and highest corner [length]; boundaries: " + join(boundaries()));
    section.add("Subdivisions", subdivisions, "coarse cells along each axis: " + an_axis, {1});
    section.add("Grading",
                grading,
                "length of the last cell (at the high end of the axis) over that of the first, "
                "geometric between: above 1, cells are fine at the low end: " +
                  an_axis,
                positive);
    if (!section.reading())
      return;
    try
      {
        const auto points = corners_from<dim>(corners);
        low               = points[0];
        high              = points[1];
      }
    catch (const SceneError &error)
      {
        section.fail("Corners", error.what());
      }
    check_size(section, "Corners", low.distance(high), std::max(low.norm(), high.norm()));
    if (subdivisions.size() != dim)
      section.fail("Subdivisions", "must have " + std::to_string(dim) + " numbers");
    check_number_of_cells(section, "Subdivisions", subdivisions);
    if (grading.size() != dim)
      section.fail("Grading", "must have " + std::to_string(dim) + " numbers");
  }



  template <int dim>
  std::vector<NamedSurface<dim>>
  BoxMesh<dim>::surfaces() const
  {
    std::vector<std::pair<std::string, std::string>> names{{"left", "right"}};
    if (dim == 3)
      names.push_back({"front", "back"});
    names.push_back({"bottom", "top"});

    const double                   size = low.distance(high);
    std::vector<NamedSurface<dim>> result;
    for (unsigned int d = 0; d < dim; ++d)
      {
        result.push_back(plane<dim>(names[d].first, d, low[d], size));
        result.push_back(plane<dim>(names[d].second, d, high[d], size));
      }
    return result;
  }



  template <int dim>
  std::vector<std::string>
  BoxMesh<dim>::boundaries() const
  {
    return names_of(surfaces());
  }



  // Cells can be merged as often as all numbers of subdivisions are divisible by two. Small boxes
  // and graded ones are not merged.
  template <int dim>
  unsigned int
  BoxMesh<dim>::possible_merges() const
  {
    constexpr double few = 1000;
    double           n   = 1;
    for (unsigned int d = 0; d < dim; ++d)
      n *= subdivisions[d];
    const bool is_uniform =
      std::all_of(grading.begin(), grading.end(), [](const double g) { return g == 1; });
    if (dim == 2 || n <= few || !is_uniform)
      return 0;
    unsigned int merges = 0;
    while (std::all_of(subdivisions.begin(), subdivisions.end(), [&](const unsigned int cells) {
      return cells % (2u << merges) == 0;
    }))
      ++merges;
    return merges;
  }



  template <int dim>
  CoarseMesh<dim>
  BoxMesh<dim>::generate_merged(const unsigned int merges) const
  {
    std::vector<std::vector<double>> step_sizes;
    for (unsigned int d = 0; d < dim; ++d)
      step_sizes.push_back(steps(high[d] - low[d], subdivisions[d] >> merges, grading[d]));
    Triangulation<dim> triangulation;
    GridGenerator::subdivided_hyper_rectangle(triangulation, step_sizes, low, high);
    return with_boundaries(triangulation, surfaces());
  }



  template <int dim>
  std::unique_ptr<MeshGenerator<dim>>
  make_box()
  {
    return std::make_unique<BoxMesh<dim>>();
  }



  template std::unique_ptr<MeshGenerator<2>>
  make_box();
  template std::unique_ptr<MeshGenerator<3>>
  make_box();
} // namespace Signorini
