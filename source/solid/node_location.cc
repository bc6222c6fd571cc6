// SPDX-License-Identifier: Apache-2.0
#include "solid/node_location.h"

#include "geometry/face_parameter.h"
#include <signorini/parameters/raw.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // Reference coordinates of coarse nodes are multiples of 1/2, and those of refined ones are
    // exact binary fractions; the tolerance is far below their spacing.
    template <int dim>
    bool
    are_same(const Point<dim> &a, const Point<dim> &b)
    {
      return a.distance_square(b) < 1e-20;
    }

  } // namespace



  // Nodes are sorted by the coarse cells that have them. Nodes that lie between corners of the set
  // (mid-side nodes of a file of degree 2) exist in the sense of the set even if the mesh has no
  // node there.
  template <int dim>
  ListedNodes<dim>::ListedNodes(const Mesh<dim> &mesh, const NodeSet<dim> &nodes)
    : mesh(mesh)
    , is_there(nodes.nodes.size(), 0)
  {
    for (unsigned int n = 0; n < nodes.nodes.size(); ++n)
      for (const NodeLocation<dim> &place : nodes.nodes[n])
        by_cell[place.cell].push_back({place.unit, n});
    for (const NodeLocation<dim> &place : nodes.left_out)
      left_out[place.cell].push_back(place.unit);
    for (const auto &[cell, listed] : by_cell)
      for (const Listed &one : listed)
        if (has_all_around(cell, one.unit))
          is_there[one.node] = 1;
  }



  // The path of an active cell is listed from the coarse cell downwards; it is followed back
  // upwards.
  template <int dim>
  Point<dim>
  in_coarse_cell(const CellId &cell, const Point<dim> &unit)
  {
    const auto children = cell.get_child_indices();
    Point<dim> x        = unit;
    for (unsigned int i = children.size(); i-- > 0;)
      x = GeometryInfo<dim>::child_to_cell_coordinates(x, children[i]);
    return x;
  }



  template <int dim>
  bool
  ListedNodes<dim>::contains(const CellId &cell, const Point<dim> &unit)
  {
    const Point<dim> x = in_coarse_cell(cell, unit);
    for (const Listed &one : by_cell.at(cell.get_coarse_cell_id()))
      if (are_same(one.unit, x))
        {
          is_there[one.node] = 1;
          return true;
        }
    return has_all_around(cell.get_coarse_cell_id(), x);
  }



  // The vertex, edge, face or cell in whose interior the point lies has the corners whose linear
  // functions do not vanish there.
  template <int dim>
  bool
  ListedNodes<dim>::has_all_around(const unsigned int coarse_cell, const Point<dim> &unit) const
  {
    const ReferenceCell        cell      = mesh.reference_cell_of(coarse_cell);
    const std::vector<Listed> &listed    = by_cell.at(coarse_cell);
    const auto                 is_around = [&](const unsigned int v, const Point<dim> &x) {
      return cell.d_linear_shape_function(x, v) > 1e-10;
    };
    const auto vertices = cell.vertex_indices();
    for (const unsigned int v : vertices)
      if (is_around(v, unit) && std::none_of(listed.begin(), listed.end(), [&](const Listed &one) {
            return are_same(one.unit, cell.vertex<dim>(v));
          }))
        return false;
    // No node that the set leaves out may lie there, or on its boundary.
    const auto others = left_out.find(coarse_cell);
    return others == left_out.end() ||
           std::none_of(others->second.begin(), others->second.end(), [&](const Point<dim> &x) {
             return std::all_of(vertices.begin(), vertices.end(), [&](const unsigned int v) {
               return !is_around(v, x) || is_around(v, unit);
             });
           });
  }



  template <int dim>
  unsigned int
  ListedNodes<dim>::n_missing(const MPI_Comm comm) const
  {
    // A node counts as found if any rank has it.
    std::vector<unsigned int> anywhere(is_there.size());
    Utilities::MPI::max(is_there, comm, anywhere);
    return std::count(anywhere.begin(), anywhere.end(), 0u);
  }



  // Follow the descendants; at an interface x = 1/2 the point belongs to the child with the lower
  // number.
  template <int dim>
  bool
  descend(const CellId &cell, Point<dim> &unit)
  {
    for (const unsigned int child : cell.get_child_indices())
      {
        unsigned int own = 0;
        for (unsigned int d = 0; d < dim; ++d)
          own += (unit[d] > 0.5) << d;
        if (own != child)
          return false;
        unit = GeometryInfo<dim>::cell_to_child_coordinates(unit, child);
      }
    return true;
  }



  namespace
  {
    /// The order of the cells that may contain a point, which does not depend on ranks: by
    /// distance, then by the global id of the cell.
    struct Claim
    {
      double       distance = std::numeric_limits<double>::infinity();
      std::string  cell;
      unsigned int body = 0;

      bool
      operator<(const Claim &other) const
      {
        return distance != other.distance ? distance < other.distance : cell < other.cell;
      }

      template <class Archive>
      void
      serialize(Archive &ar, const unsigned int)
      {
        ar &distance &cell &body;
      }
    };

    // Distances in reference coordinates: below `same` the cell contains the point; beyond
    // `farthest` it does not.
    constexpr double same = 1e-6, farthest = 0.02;

    /// The distance of a point from a cell in its reference coordinates, zero inside and on its
    /// faces; infinite if the point is far away or the mapping cannot be inverted.
    /// @param unit set to the nearest point of the cell, in reference coordinates
    template <int dim>
    double
    distance_from(const Mesh<dim>                                         &mesh,
                  const typename Triangulation<dim>::active_cell_iterator &cell,
                  const Point<dim>                                        &x,
                  Point<dim>                                              &unit)
    {
      BoundingBox<dim> box = cell->bounding_box();
      box.extend(0.25 * cell->diameter()); // curved edges leave the box of the vertices
      if (!box.point_inside(x))
        return std::numeric_limits<double>::infinity();
      try
        {
          unit                      = mesh.mapping().transform_real_to_unit_cell(cell, x);
          const Point<dim> nearest  = nearest_in_cell(cell->reference_cell(), unit);
          const double     distance = nearest.distance(unit);
          unit                      = nearest;
          return distance <= same ? 0 : distance;
        }
      catch (const typename Mapping<dim>::ExcTransformationFailed &)
        {
          return std::numeric_limits<double>::infinity();
        }
    }
  } // namespace



  // Each rank finds its best cell; the best of all ranks wins, and exactly one rank has it. Cost:
  // one inversion of the mapping for each cell whose box has the point.
  template <int dim>
  PointLocation<dim>
  locate(const Mesh<dim>   &mesh,
         const Point<dim>  &x,
         const std::string &body,
         const std::string &what)
  {
    PointLocation<dim>        place;
    Claim                     best;
    std::vector<unsigned int> has_it(mesh.n_bodies(), 0);
    for (const auto &cell : mesh.triangulation().active_cell_iterators())
      if (cell->is_locally_owned() && (body.empty() || mesh.body_name(mesh.body(cell)) == body))
        {
          Point<dim> unit;
          // A cell with a smaller distance wins; for points on common faces both are zero, and the
          // global id decides, so that the result does not depend on the partition.
          const Claim claim{distance_from(mesh, cell, x, unit),
                            cell->id().to_string(),
                            mesh.body(cell)};
          if (claim.distance == 0)
            has_it[claim.body] = 1;
          if (claim.distance <= farthest && claim < best)
            {
              best              = claim;
              place.active_cell = cell->active_cell_index();
              place.unit        = unit;
            }
        }
    const auto claims = Utilities::MPI::all_gather(mesh.communicator(), best);
    const auto winner = std::min_element(claims.begin(), claims.end());
    if (winner->distance > farthest)
      throw SceneError(what + ": the point is outside of " +
                       (body.empty() ? "all bodies" : "the body '" + body + "'"));
    Utilities::MPI::max(has_it, mesh.communicator(), has_it);
    if (std::count(has_it.begin(), has_it.end(), 1u) > 1)
      throw SceneError(what + ": several bodies have the point; say which one by 'Point body'");
    place.is_on_this_rank =
      winner - claims.begin() == Utilities::MPI::this_mpi_process(mesh.communicator());
    return place;
  }



#define INSTANTIATE(dim)                                                                           \
  template class ListedNodes<dim>;                                                                 \
  template bool               descend(const CellId &, Point<dim> &);                               \
  template Point<dim>         in_coarse_cell(const CellId &, const Point<dim> &);                  \
  template PointLocation<dim> locate(const Mesh<dim> &,                                            \
                                     const Point<dim> &,                                           \
                                     const std::string &,                                          \
                                     const std::string &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
