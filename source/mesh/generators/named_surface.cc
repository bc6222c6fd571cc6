// SPDX-License-Identifier: Apache-2.0
#include "mesh/generators/named_surface.h"

#include <signorini/parameters/section.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    const double tolerance = 1e-8;

    /// @return whether a surface contains all vertices of a face.
    template <int dim>
    bool
    contains(const NamedSurface<dim>                          &surface,
             const typename Triangulation<dim>::face_iterator &face)
    {
      for (const unsigned int v : face->vertex_indices())
        if (!surface.contains(face->vertex(v)))
          return false;
      return true;
    }
  } // namespace



  void
  check_size(const Section &section, const std::string &key, const double size, const double reach)
  {
    // Squares of lengths must be representable, and coordinates of neighbouring points must differ.
    if (!(size > 1e-100 && reach < 1e100 && reach < 1e7 * size))
      section.fail(key,
                   "is too small, too large or too far from the origin for double precision; use "
                   "other units, or shift the model");
  }



  template <int dim>
  NamedSurface<dim>
  plane(const std::string &name, const unsigned int axis, const double value, const double size)
  {
    return {name,
            [=](const Point<dim> &p) { return std::abs(p[axis] - value) < tolerance * size; },
            nullptr};
  }



  template <int dim>
  NamedSurface<dim>
  sphere(const std::string &name, const Point<dim> &center, const double radius)
  {
    return {name,
            [=](const Point<dim> &p) {
              return std::abs(p.distance(center) - radius) < tolerance * radius;
            },
            nullptr};
  }



  template <int dim>
  std::vector<std::string>
  names_of(const std::vector<NamedSurface<dim>> &surfaces)
  {
    std::vector<std::string> names;
    for (const auto &surface : surfaces)
      names.push_back(surface.name);
    return names;
  }



  // The boundary id of a face is the index of its surface; manifold ids are larger by one.
  template <int dim>
  CoarseMesh<dim>
  with_boundaries(Triangulation<dim> &triangulation, const std::vector<NamedSurface<dim>> &surfaces)
  {
    for (const auto &face : triangulation.active_face_iterators())
      if (face->at_boundary())
        {
          const auto surface =
            std::find_if(surfaces.begin(), surfaces.end(), [&](const NamedSurface<dim> &candidate) {
              return contains(candidate, face);
            });
          AssertThrow(surface != surfaces.end(), ExcInternalError());
          const unsigned int index = surface - surfaces.begin();
          face->set_boundary_id(index);
          if (surface->manifold)
            {
              face->set_all_manifold_ids(index + 1);
              triangulation.set_manifold(index + 1, *surface->manifold);
            }
        }
    return CoarseMesh<dim>::from_triangulation(triangulation, names_of(surfaces));
  }



#define INSTANTIATE(dim)                                                                           \
  template NamedSurface<dim>        plane(const std::string &, unsigned int, double, double);      \
  template NamedSurface<dim>        sphere(const std::string &, const Point<dim> &, double);       \
  template std::vector<std::string> names_of(const std::vector<NamedSurface<dim>> &);              \
  template CoarseMesh<dim>          with_boundaries(Triangulation<dim> &,                          \
                                                    const std::vector<NamedSurface<dim>> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
