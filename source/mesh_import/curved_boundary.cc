// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/curved_boundary.h"

#include "geometry/manifolds.h"
#include <signorini/parameters/section.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  std::unique_ptr<Manifold<dim>>
  CurvedBoundary<dim>::manifold() const
  {
    return std::make_unique<RoundManifold<dim>>(center, axis);
  }



  template <int dim>
  Tensor<1, dim>
  CurvedBoundary<dim>::arm(const Point<dim> &p) const
  {
    return (p - center) - ((p - center) * axis) * axis;
  }



  // Collect the vertices of all faces of the boundary, those of the file and inserted ones
  // separately.
  template <int dim>
  void
  CurvedBoundary<dim>::apply(Triangulation<dim>                 &triangulation,
                             const std::set<types::boundary_id> &boundary,
                             const types::manifold_id            manifold_id,
                             const std::vector<bool>            &inserted) const
  {
    std::set<Point<dim> *, std::less<>> vertices, between;
    for (const auto &face : triangulation.active_face_iterators())
      if (face->at_boundary() && boundary.count(face->boundary_id()) > 0)
        {
          face->set_all_manifold_ids(manifold_id);
          for (const unsigned int v : face->vertex_indices())
            (inserted[face->vertex_index(v)] ? between : vertices).insert(&face->vertex(v));
        }
    triangulation.set_manifold(manifold_id, *manifold());

    // The radius is the mean over the vertices of the file, which must all be on the surface up to
    // 1e-3 of it. Then all vertices, also the inserted ones, are moved onto the surface radially.
    double radius = 0, deviation = 0;
    for (const Point<dim> *vertex : vertices)
      radius += arm(*vertex).norm() / vertices.size();
    for (const Point<dim> *vertex : vertices)
      deviation = std::max(deviation, std::abs(arm(*vertex).norm() - radius));
    if (deviation > 1e-3 * radius)
      throw SceneError(
        "the vertices of '" + name + "' do not lie on one such surface: their distance " +
        (axis.norm() > 0 ? "from the axis" : "from the center") + " is " + std::to_string(radius) +
        " with deviations up to " + std::to_string(deviation));
    vertices.insert(between.begin(), between.end());
    for (Point<dim> *vertex : vertices)
      *vertex += arm(*vertex) * (radius / arm(*vertex).norm() - 1);
  }



  namespace
  {
    /// A kind of surface: the word in the scene, and how many numbers follow it.
    struct Kind
    {
      std::string  word;
      unsigned int n_numbers;
    };

    /// @return the kinds of surfaces that exist in this dimension.
    template <int dim>
    std::vector<Kind>
    kinds()
    {
      if (dim == 2)
        return {{"circle", 2}};
      return {{"sphere", 3}, {"cylinder", 6}};
    }



    /// @return the numbers of a text, between which there may be blanks and commas. Throws
    /// SceneError.
    std::vector<double>
    numbers_from(std::string text)
    {
      std::replace(text.begin(), text.end(), ',', ' ');
      std::vector<double> result;
      for (const std::string &word : split(text, ' '))
        if (!word.empty())
          {
            result.emplace_back();
            from_text(word, result.back());
          }
      return result;
    }



    /// @return the boundary with centre (or point of the axis) and, if there are twice as many
    /// numbers, the direction of its axis.
    template <int dim>
    CurvedBoundary<dim>
    make(const std::string &name, const std::vector<double> &x)
    {
      CurvedBoundary<dim> boundary;
      boundary.name = name;
      for (unsigned int d = 0; d < dim; ++d)
        boundary.center[d] = x[d];
      if (x.size() == 2 * dim)
        {
          for (unsigned int d = 0; d < dim; ++d)
            boundary.axis[d] = x[dim + d];
          if (boundary.axis.norm() == 0)
            throw SceneError("the direction of the axis of '" + name + "' is zero");
          boundary.axis /= boundary.axis.norm();
        }
      return boundary;
    }



    /// @return the boundary that one item describes. The name of the boundary may contain blanks:
    /// the last word that is a kind counts.
    template <int dim>
    CurvedBoundary<dim>
    boundary_from(const std::string &item)
    {
      for (const Kind &kind : kinds<dim>())
        {
          const auto at = item.rfind(" " + kind.word + " ");
          if (at == std::string::npos)
            continue;
          const std::vector<double> numbers = numbers_from(item.substr(at + kind.word.size() + 2));
          if (numbers.size() != kind.n_numbers)
            throw SceneError("'" + item + "' must have " + std::to_string(kind.n_numbers) +
                             " numbers after the word " + kind.word);
          return make<dim>(trim(item.substr(0, at)), numbers);
        }
      throw SceneError("'" + item + "' is not of the form " +
                       (dim == 2 ? "NAME circle cx cy" :
                                   "NAME sphere cx cy cz or NAME cylinder px py pz ax ay az"));
    }
  } // namespace



  template <int dim>
  std::vector<CurvedBoundary<dim>>
  curved_boundaries_from(const std::string &text)
  {
    std::vector<CurvedBoundary<dim>> result;
    for (const std::string &item : split(text, ';'))
      result.push_back(boundary_from<dim>(item));
    return result;
  }



  template struct CurvedBoundary<2>;
  template struct CurvedBoundary<3>;
  template std::vector<CurvedBoundary<2>>
  curved_boundaries_from(const std::string &);
  template std::vector<CurvedBoundary<3>>
  curved_boundaries_from(const std::string &);
} // namespace Signorini
