// SPDX-License-Identifier: Apache-2.0
#include "geometry/manifolds.h"
#include "mesh_import/cells.h"
#include "mesh_import/import_steps.h"
#include <signorini/parameters/raw.h>

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



    /// Give a face or line a manifold id unless it has one.
    template <typename Object>
    void
    give(const Object &object, const types::manifold_id id)
    {
      if (object->manifold_id() == numbers::flat_manifold_id)
        object->set_manifold_id(id);
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
        const QuadraticMap<dim> map = map_of<dim>(element, file);
        if (map.is_multilinear())
          continue;
        if (!map.is_invertible())
          throw SceneError("has element " + std::to_string(element.number) + " at " +
                           text_of(map.value(Point<dim>())) +
                           ", which is inverted by its mid-side nodes; improve the mesh there, or "
                           "set Mid-side nodes = no");
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
