// SPDX-License-Identifier: Apache-2.0
#include "fields/probe_cells.h"

#include "geometry/face_parameter.h"
#include <signorini/parameters/raw.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    using Cell = typename DoFHandler<dim>::active_cell_iterator;

    // Distances are in reference coordinates of a cell. Points closer than this to a face belong to
    // both cells.
    constexpr double same = 1e-6;



    /// @return whether candidate a is preferred: the closest cell, then the first body, then the
    /// lowest centre.
    template <int dim>
    bool
    takes_precedence(const Claim<dim> &a, const Claim<dim> &b)
    {
      if (a.distance != b.distance)
        return a.distance < b.distance;
      if (a.body != b.body)
        return a.body < b.body;
      // Centres are compared with a tolerance, since their coordinates may differ by rounding from
      // rank to rank.
      for (unsigned int d = 0; d < dim; ++d)
        if (std::abs(a.center[d] - b.center[d]) > same * (a.size + b.size))
          return a.center[d] < b.center[d];
      return false;
    }



    /// @return a point in the coordinates of a cell; with infinite distance if it is farther than
    /// `farthest`.
    template <int dim>
    CellLocation<dim>
    place_in(const Mapping<dim> &mapping,
             const Cell<dim>    &cell,
             const Point<dim>   &x,
             const double        farthest)
    {
      CellLocation<dim> location;
      try
        {
          const Point<dim> unit    = mapping.transform_real_to_unit_cell(cell, x),
                           nearest = nearest_in_cell(cell->reference_cell(), unit);
          const double distance    = nearest.distance(unit);
          if (distance <= farthest)
            {
              location.cell  = cell;
              location.unit  = nearest;
              location.claim = {distance <= same ? 0 : distance,
                                cell->material_id(),
                                cell->center(),
                                cell->diameter()};
            }
        }
      catch (const typename Mapping<dim>::ExcTransformationFailed &)
        {
          // The mapping could not be inverted: the point is far from the cell.
        }
      return location;
    }



    /// @return whether a probe belongs to this body, and its point is in the box.
    template <int dim>
    bool
    may_be_in(const Probe<dim> &probe, const std::string &body, const BoundingBox<dim> &box)
    {
      return (probe.body.empty() || probe.body == body) && box.point_inside(probe.point);
    }



    /// @return the extent of a body for messages.
    template <int dim>
    std::string
    extent_of_body(const Mesh<dim> &mesh, const unsigned int body)
    {
      const auto &[low, high] = mesh.extent(body).get_boundary_points();
      return "from " + point_text(low) + " to " + point_text(high);
    }
  } // namespace



  template <int dim>
  std::vector<CellLocation<dim>>
  own_locations(const Elasticity<dim>         &elasticity,
                const std::vector<Probe<dim>> &probes,
                const double                   farthest)
  {
    const Mesh<dim>               &mesh = elasticity.mesh();
    std::vector<CellLocation<dim>> best(probes.size());
    for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          // The box is that of the vertices; an edge that is a quarter of a circle extends beyond
          // it by a fifth of its length.
          BoundingBox<dim> box = cell->bounding_box();
          box.extend(0.25 * cell->diameter());
          for (unsigned int i = 0; i < probes.size(); ++i)
            if (may_be_in(probes[i], mesh.body_name(mesh.body(cell)), box))
              {
                const CellLocation<dim> location =
                  place_in<dim>(mesh.mapping(), cell, probes[i].point, farthest);
                if (takes_precedence(location.claim, best[i].claim))
                  best[i] = location;
              }
        }
    return best;
  }



  template <int dim>
  unsigned int
  rank_of_best_claim(const std::vector<std::vector<Claim<dim>>> &claims, const unsigned int i)
  {
    return std::min_element(claims.begin(),
                            claims.end(),
                            [i](const auto &a, const auto &b) {
                              return takes_precedence(a[i], b[i]);
                            }) -
           claims.begin();
  }



  template <int dim>
  std::vector<std::vector<Claim<dim>>>
  all_claims(const std::vector<CellLocation<dim>> &locations, const MPI_Comm comm)
  {
    std::vector<Claim<dim>> claims;
    for (const CellLocation<dim> &location : locations)
      claims.push_back(location.claim);
    return Utilities::MPI::all_gather(comm, claims);
  }



  template <int dim>
  std::vector<CellLocation<dim>>
  cells_about(const Mapping<dim> &mapping, const CellLocation<dim> &first, const Point<dim> &x)
  {
    std::vector<CellLocation<dim>> locations = {first};
    std::set<Cell<dim>>            seen      = {first.cell};
    const auto                     visit     = [&](const Cell<dim> &cell) {
      if (!cell->is_artificial() && seen.insert(cell).second)
        if (const CellLocation<dim> location =
              place_in<dim>(mapping, cell, x, first.claim.distance + same);
            location.claim.distance <= first.claim.distance + same)
          locations.push_back(location);
    };
    // The list grows while it is traversed, by neighbours that contain the point as well; it ends
    // because each cell is visited at most once, and only cells with the point are continued from.
    for (unsigned int i = 0; i < locations.size(); ++i)
      {
        const Cell<dim> cell = locations[i].cell;
        for (const unsigned int f : cell->face_indices())
          if (!cell->at_boundary(f))
            {
              if (!cell->neighbor(f)->has_children())
                visit(cell->neighbor(f));
              else
                for (unsigned int c = 0; c < cell->face(f)->n_children(); ++c)
                  visit(cell->neighbor_child_on_subface(f, c));
            }
      }
    return locations;
  }



  template <int dim>
  [[noreturn]] void
  throw_outside_of_bodies(const Probe<dim> &probe, const Mesh<dim> &mesh)
  {
    std::vector<std::string> extents, names;
    for (unsigned int b = 0; b < mesh.n_bodies(); ++b)
      {
        names.push_back(mesh.body_name(b));
        if (probe.body.empty() || probe.body == names.back())
          extents.push_back("'" + names.back() + "' extends " + extent_of_body(mesh, b));
      }
    const std::string which = "probe '" + probe.name + "' at " + point_text(probe.point) + ": ";
    if (extents.empty())
      throw SceneError(which + "there is no body '" + probe.body + "'; the bodies are " +
                       join(names));
    throw SceneError(which + "the point is outside of " +
                     (probe.body.empty() ? "all bodies" : "its body") + "; " + join(extents, ", "));
  }



  template std::vector<CellLocation<2>>
  own_locations(const Elasticity<2> &, const std::vector<Probe<2>> &, double);
  template unsigned int
  rank_of_best_claim(const std::vector<std::vector<Claim<2>>> &, unsigned int);
  template std::vector<std::vector<Claim<2>>>
  all_claims(const std::vector<CellLocation<2>> &, MPI_Comm);
  template std::vector<CellLocation<2>>
  cells_about(const Mapping<2> &, const CellLocation<2> &, const Point<2> &);
  template void
  throw_outside_of_bodies(const Probe<2> &, const Mesh<2> &);
  template std::vector<CellLocation<3>>
  own_locations(const Elasticity<3> &, const std::vector<Probe<3>> &, double);
  template unsigned int
  rank_of_best_claim(const std::vector<std::vector<Claim<3>>> &, unsigned int);
  template std::vector<std::vector<Claim<3>>>
  all_claims(const std::vector<CellLocation<3>> &, MPI_Comm);
  template std::vector<CellLocation<3>>
  cells_about(const Mapping<3> &, const CellLocation<3> &, const Point<3> &);
  template void
  throw_outside_of_bodies(const Probe<3> &, const Mesh<3> &);
} // namespace Signorini
