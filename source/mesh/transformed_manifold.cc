// SPDX-License-Identifier: Apache-2.0
#include "mesh/transformed_manifold.h"

#include "geometry/cell_size.h"
#include "mesh_import/cells.h"
#include <signorini/parameters/raw.h>

#include <deal.II/base/geometry_info.h>

#include <algorithm>
#include <set>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  TransformedManifold<dim>::TransformedManifold(std::shared_ptr<const InvertibleMap<dim>> map,
                                                std::shared_ptr<const Manifold<dim>>      base)
    : map(std::move(map))
    , base(base ? std::move(base) : std::make_shared<FlatManifold<dim>>())
  {}



  template <int dim>
  std::unique_ptr<Manifold<dim>>
  TransformedManifold<dim>::clone() const
  {
    return std::make_unique<TransformedManifold<dim>>(map, base);
  }



  template <int dim>
  std::vector<Point<dim>>
  TransformedManifold<dim>::before_map(const Points &points) const
  {
    std::vector<Point<dim>> result;
    for (const Point<dim> &x : points)
      result.push_back(map->inverse(x));
    return result;
  }



  // All points are mapped back by the inverse of F, the base manifold finds the new point, and F
  // maps it forward: x = F(base(F^-1(x_1), F^-1(x_2), ...)).
  template <int dim>
  Point<dim>
  TransformedManifold<dim>::get_intermediate_point(const Point<dim> &p1,
                                                   const Point<dim> &p2,
                                                   const double      w) const
  {
    return map->value(base->get_intermediate_point(map->inverse(p1), map->inverse(p2), w));
  }



  template <int dim>
  Point<dim>
  TransformedManifold<dim>::get_new_point(const Points                  &surrounding,
                                          const ArrayView<const double> &weights) const
  {
    const std::vector<Point<dim>> X = before_map(surrounding);
    return map->value(base->get_new_point(make_array_view(X), weights));
  }



  // As for one new point, but the surrounding points are mapped back only once.
  template <int dim>
  void
  TransformedManifold<dim>::get_new_points(const Points           &surrounding,
                                           const Table<2, double> &weights,
                                           ArrayView<Point<dim>>   new_points) const
  {
    const std::vector<Point<dim>> X = before_map(surrounding);
    base->get_new_points(make_array_view(X), weights, new_points);
    for (Point<dim> &p : new_points)
      p = map->value(p);
  }



  template <int dim>
  Point<dim>
  TransformedManifold<dim>::project_to_manifold(const Points     &surrounding,
                                                const Point<dim> &candidate) const
  {
    const std::vector<Point<dim>> X = before_map(surrounding);
    return map->value(base->project_to_manifold(make_array_view(X), map->inverse(candidate)));
  }



  // The tangent of the base manifold is pushed forward by the gradient of F.
  // By the chain rule, the curve F(X(t)) has the tangent Grad F (dX/dt).
  template <int dim>
  Tensor<1, dim>
  TransformedManifold<dim>::get_tangent_vector(const Point<dim> &x1, const Point<dim> &x2) const
  {
    const Point<dim> X1 = map->inverse(x1);
    return map->gradient(X1) * base->get_tangent_vector(X1, map->inverse(x2));
  }



  namespace
  {
    /// @return the lines or the quadrilaterals of the list.
    template <int structdim>
    std::vector<CellData<structdim>> &
    list(SubCellData &faces)
    {
      if constexpr (structdim == 1)
        return faces.boundary_lines;
      else
        return faces.boundary_quads;
    }



    /// Appends lines or faces that are not in the list yet.
    template <int structdim>
    class Completion
    {
    public:
      explicit Completion(SubCellData &faces)
        : objects(list<structdim>(faces))
      {
        for (const auto &object : objects)
          known.insert(sorted(object.vertices));
      }

      /// Append an object with these vertices, unless it is in the list.
      void
      add(const std::vector<unsigned int> &vertices)
      {
        if (!known.insert(sorted(vertices)).second)
          return;
        objects.emplace_back();
        objects.back().vertices    = vertices;
        objects.back().boundary_id = numbers::internal_face_boundary_id;
      }

    private:
      std::vector<CellData<structdim>>   &objects;
      std::set<std::vector<unsigned int>> known;
    };



    /// Append all missing faces and lines of the cells, so that all of them can have manifold ids.
    /// Only objects in the list of faces and lines can get a manifold id; inner ones are usually
    /// not in it, but a transformation bends them as well.
    template <int dim>
    void
    complete_faces(CoarseMesh<dim> &mesh)
    {
      Completion<dim - 1> faces(mesh.faces);
      Completion<1>       lines(mesh.faces);
      for (const auto &cell : mesh.cells)
        {
          for (const unsigned int f : reference_cell_of(cell).face_indices())
            faces.add(face_nodes(cell, f));
          if (dim == 3)
            for (const auto &[a, b] : lines_of(cell))
              lines.add({a, b});
        }
    }



    /// Throw SceneError if the transformation has inverted or mirrored a cell.
    template <int dim>
    void
    check_orientation(const CoarseMesh<dim> &mesh, const std::string &formulas)
    {
      for (const auto &cell : mesh.cells)
        {
          std::vector<Point<dim>> corners;
          for (const unsigned int v : cell.vertices)
            corners.push_back(mesh.vertices[v]);
          const std::vector<double> volumes = determinants_at_corners(corners);
          for (unsigned int v = 0; v < volumes.size(); ++v)
            if (!(volumes[v] > 0)) // also NaN
              {
                std::ostringstream place;
                place << corners[v];
                throw SceneError("the transformation '" + formulas +
                                 "' inverts or mirrors the cell that is mapped to (" + place.str() +
                                 ")");
              }
        }
    }
  } // namespace



  // Flat manifolds are transformed as well, since straight lines become curves. Without curvature
  // before and after, no manifold is needed.
  template <int dim>
  bool
  transform(CoarseMesh<dim> &mesh, const bool is_curved, const VectorExpression<dim> &F)
  {
    const auto map = std::make_shared<InvertibleMap<dim>>(F, mesh.vertices);
    for (Point<dim> &vertex : mesh.vertices)
      vertex = map->value(vertex);
    check_orientation(mesh, F.text());
    if (!is_curved && map->is_affine())
      return false;

    // Each manifold id, also that of flat parts, gets its own transformed manifold. Former
    // manifolds become the bases.
    complete_faces(mesh);
    // Ids that had no manifold, such as that of flat parts, get one with a flat base.
    const auto                                       former = std::move(mesh.manifolds);
    std::map<types::manifold_id, types::manifold_id> new_ids;
    mesh.manifolds.clear();
    mesh.map_manifold_ids([&](const types::manifold_id id) {
      const auto [entry, is_new] = new_ids.insert({id, new_ids.size()});
      if (is_new)
        {
          const auto base               = former.find(id);
          mesh.manifolds[entry->second] = std::make_shared<TransformedManifold<dim>>(
            map, base == former.end() ? nullptr : base->second);
        }
      return entry->second;
    });
    return true;
  }



  template class TransformedManifold<2>;
  template class TransformedManifold<3>;
  template bool
  transform(CoarseMesh<2> &, bool, const VectorExpression<2> &);
  template bool
  transform(CoarseMesh<3> &, bool, const VectorExpression<3> &);
} // namespace Signorini
