// SPDX-License-Identifier: Apache-2.0
#include "geometry/manifolds.h"
#include "mesh_import/cells.h"
#include "mesh_import/division/cell_shape.h"
#include "mesh_import/import_steps.h"
#include <signorini/parameters/raw.h>

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// @return the map from the reference cell that the nodes of an element define.
    template <int dim>
    QuadraticMap<dim>
    map_of(const MeshFile::Element &element, const MeshFile &file)
    {
      std::vector<Point<dim>> nodes(element.nodes.size());
      for (unsigned int i = 0; i < nodes.size(); ++i)
        for (unsigned int d = 0; d < dim; ++d)
          nodes[i][d] = file.nodes[element.nodes[i]][d];
      return QuadraticMap<dim>(nodes);
    }



    /// @return the error of an element that is inverted.
    /// @param place its first corner
    template <int dim>
    SceneError
    inverted(const MeshFile::Element &element, const Point<dim> &place)
    {
      return SceneError("has element " + std::to_string(element.number) + " at " + text_of(place) +
                        ", which is inverted by its mid-side nodes; improve the mesh there, or set "
                        "Mid-side nodes = no");
    }



    /// Give a face or line a manifold id unless it has one.
    template <typename Object>
    void
    give(const Object &object, const types::manifold_id id)
    {
      if (object->manifold_id() == numbers::flat_manifold_id)
        object->set_manifold_id(id);
    }
  } // namespace



  namespace
  {
    /// Give the lines of a simplex of second order that are not straight and evenly divided
    /// manifolds through their nodes in the middle.
    /// @param next the next manifold id
    /// @return the next manifold id
    template <int dim>
    types::manifold_id
    curve_lines(Triangulation<dim>                                      &triangulation,
                const typename Triangulation<dim>::active_cell_iterator &cell,
                const MeshFile::Element                                 &element,
                const MeshFile                                          &file,
                types::manifold_id                                       next)
    {
      constexpr double small = 1e-8; // of the length of the line
      const auto       place = [&](const unsigned int node) {
        Point<dim> x;
        for (unsigned int d = 0; d < dim; ++d)
          x[d] = file.nodes[element.nodes[node]][d];
        return x;
      };
      std::vector<Point<dim>> nodes;
      for (const unsigned int v : cell->vertex_indices())
        nodes.push_back(cell->vertex(v));
      const auto        &edges     = CellShape::of(element.shape).edges;
      bool               is_curved = false;
      const unsigned int n         = n_corners(element.shape);
      for (const unsigned int l : cell->line_indices())
        {
          // The edge of the element with the same ends: cells may be numbered otherwise.
          const auto         line   = cell->line(l);
          const Point<dim>   middle = line->center();
          const double       length = line->vertex(0).distance(line->vertex(1));
          const unsigned int edge =
            std::min_element(edges.begin(),
                             edges.end(),
                             [&](const auto &a, const auto &b) {
                               return ((place(a[0]) - middle) + (place(a[1]) - middle)).norm() <
                                      ((place(b[0]) - middle) + (place(b[1]) - middle)).norm();
                             }) -
            edges.begin();
          nodes.push_back(place(n + edge));
          const Tensor<1, dim> bend = nodes.back() - middle;
          if (bend.norm() <= small * length)
            continue;
          is_curved = true;
          if (line->manifold_id() != numbers::flat_manifold_id)
            continue;
          triangulation.set_manifold(next, ParabolicLine<dim>(bend));
          line->set_manifold_id(next++);
        }
      if (is_curved && is_inverted_simplex(nodes))
        throw inverted(element, nodes[0]);
      return next;
    }
  } // namespace



  // Elements of first order, and those of second order with straight, evenly divided edges, need no
  // manifold.
  template <int dim>
  unsigned int
  curve_cells(Triangulation<dim>                           &triangulation,
              const MeshFile                               &file,
              const std::vector<const MeshFile::Element *> &elements,
              const types::manifold_id                      first)
  {
    unsigned int n = 0;
    for (const auto &cell : triangulation.active_cell_iterators())
      {
        const MeshFile::Element &element = *elements[cell->active_cell_index()];
        if (element.nodes.size() == n_corners(element.shape))
          continue;
        if (cell->reference_cell().is_simplex())
          {
            n = curve_lines(triangulation, cell, element, file, first + n) - first;
            continue;
          }
        const QuadraticMap<dim> map = map_of<dim>(element, file);
        if (map.is_multilinear())
          continue;
        if (!map.is_invertible())
          throw inverted(element, map.value(Point<dim>()));
        const types::manifold_id id = first + n++;
        triangulation.set_manifold(id, QuadraticManifold<dim>(map));
        cell->set_manifold_id(id);
        for (const auto &face : cell->face_iterators())
          give(face, id);
        if (dim == 3)
          for (unsigned int l = 0; l < cell->n_lines(); ++l)
            give(cell->line(l), id);
      }
    return n;
  }



  template unsigned int
  curve_cells(Triangulation<2> &,
              const MeshFile &,
              const std::vector<const MeshFile::Element *> &,
              types::manifold_id);
  template unsigned int
  curve_cells(Triangulation<3> &,
              const MeshFile &,
              const std::vector<const MeshFile::Element *> &,
              types::manifold_id);
} // namespace Signorini
