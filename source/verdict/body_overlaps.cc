// SPDX-License-Identifier: Apache-2.0
#include "contact/search/deep_penetration.h"
#include "contact/search/search_radius.h"
#include "verdict/overlaps.h"

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// @return the sample points of a that are in the bounding box of b.
    template <int dim>
    std::vector<unsigned int>
    in_box_of(const BodySurface<dim> &a, const BodySurface<dim> &b)
    {
      std::vector<unsigned int> result;
      for (unsigned int i = 0; i < a.places.size(); ++i)
        if (b.box->point_inside(a.places[i]))
          result.push_back(i);
      return result;
    }

    /// @return about so many faces on each rank of a body that are in a box in the reference
    /// configuration, at regular intervals.
    template <int dim>
    BoundaryFaces<dim>
    sample_faces(const Configuration<dim> &configuration,
                 const unsigned int        body,
                 const BoundingBox<dim>   &box,
                 const unsigned int        how_many)
    {
      const auto is_in_box = [&](const CellIterator<dim> &cell, const unsigned int face) {
        return configuration.elasticity().mesh().body(cell) == body &&
               box.point_inside(cell->face(face)->center());
      };
      // The faces are counted first, so that every n-th of them gives about the number that is
      // wanted. Both loops visit cells in the same order.
      unsigned int n = 0, next = 0;
      for (const auto &cell : configuration.elasticity().dof_handler().active_cell_iterators())
        if (cell->is_locally_owned() && cell->at_boundary())
          for (const unsigned int f : cell->face_indices())
            n += cell->face(f)->at_boundary() && is_in_box(cell, f);
      const unsigned int stride = std::max(1u, n / how_many);
      return {configuration, [&](const CellIterator<dim> &cell, const unsigned int face) {
                return is_in_box(cell, face) && next++ % stride == 0;
              }};
    }
  } // namespace



  template <int dim>
  Overlap
  overlap_of(const BodySurface<dim>       &a,
             const BodySurface<dim>       &b,
             const MonitoredSurfaces<dim> &watched,
             const MPI_Comm                comm)
  {
    // Both searches below are collective: ranks without points take part with empty lists.
    const bool                       is_self = &a == &b;
    const std::vector<unsigned int>  asked   = in_box_of(a, b);
    std::vector<Point<dim>>          places;
    std::vector<Tensor<1, dim>>      normals;
    std::vector<ReferencePoint<dim>> rest;
    for (const unsigned int i : asked)
      {
        places.push_back(a.places[i]);
        normals.push_back(a.normals[i]);
        if (is_self)
          rest.push_back(a.rest[i]);
      }
    // Closest points on b within half of the depth of the deepest cell; in self-contact without
    // neighbours in the reference configuration.
    const auto master_points = find_master_projections(
      places, normals, b.masters(is_self), a.deepest / 2, comm, nullptr, {}, rest);
    Overlap largest;
    for (unsigned int k = 0; k < master_points.size(); ++k)
      {
        if (!master_points[k])
          continue;
        const MasterProjection<dim> &master_point = *master_points[k];
        const unsigned int i = asked[k], kind = a.kinds[a.face_of[i]], other = master_point.kind;
        const double       depth = (master_point.position - a.places[i]) * master_point.normal,
                     room        = std::min(a.depth(i), master_point.size);
        // Depth along the normal of b. Beyond `room`, half of the smaller one of the two cells,
        // the point may be closer to the opposite side of b. Where a pair exists but has been
        // inactive, only deep penetrations count.
        const bool is_inactive = watched.is_inactive(kind, other);
        if (depth > (is_inactive ? much_of_cell * 2 * room : 0) &&
            master_point.position.distance(a.places[i]) < room &&
            !watched.is_monitored(kind, other))
          largest.take(
            {depth / (2 * room),
             depth,
             std::min(kind, other),
             watched.is_self(kind, other) ? PenetrationType::itself : PenetrationType::other,
             std::max(kind, other),
             is_inactive});
      }
    return largest;
  }



  template <int dim>
  Overlap
  depth_inside(const BodySurface<dim>       &a,
               const BodySurface<dim>       &b,
               const unsigned int            body,
               const MonitoredSurfaces<dim> &watched,
               const MPI_Comm                comm)
  {
    const std::vector<unsigned int> asked = in_box_of(a, b);
    std::vector<Point<dim>>         places, at_rest;
    for (const unsigned int i : asked)
      {
        places.push_back(a.places[i]);
        at_rest.push_back(a.rest[i].x);
      }
    if (Utilities::MPI::sum(asked.size(), comm) == 0)
      return {};
    // Signed depths now and in the reference configuration.
    // The diagonal of the box is the farthest distance at which a point inside of the box may have
    // its closest face.
    const auto   ends = b.box->get_boundary_points();
    const double far  = ends.first.distance(ends.second);
    const auto   now  = depths(places, b.masters(false), far, comm),
               before = depths(at_rest, b.reference_masters(), far, comm);
    // Depths are positive inside, and not finite where no face was found.
    const auto is_inside = [](const double depth, const double least) {
      return depth >= least && std::isfinite(depth);
    };
    Overlap largest;
    for (unsigned int k = 0; k < asked.size(); ++k)
      {
        const unsigned int i = asked[k], kind = a.kinds[a.face_of[i]];
        const double       cell = 2 * a.depth(i);
        // Points that were inside at the start count if they still are and no pair with that body
        // exists; others, if they were outside and are now deeper than half of a cell.
        const bool at_start = is_inside(before[k], much_of_cell * cell);
        if (at_start ? is_inside(now[k], much_of_cell * cell) && !watched.has_pair(kind, body) :
                       is_inside(now[k], cell / 2) && !(before[k] > 0 && std::isfinite(before[k])))
          largest.take({now[k] / cell, now[k], kind, PenetrationType::body, body, false, at_start});
      }
    return largest;
  }



  template <int dim>
  Overlap
  initial_depth(const Configuration<dim>     &configuration,
                const unsigned int            a,
                const unsigned int            b,
                const MonitoredSurfaces<dim> &watched)
  {
    constexpr unsigned int enough = 200;
    const Mesh<dim>       &mesh   = configuration.elasticity().mesh();
    const MPI_Comm         comm   = mesh.communicator();
    if (common_depth(mesh.extent(a), mesh.extent(b)) == 0)
      return {};
    // Sample faces of a in the bounding box of b, against the whole surface of b.
    BodySurface<dim> asking(sample_faces(configuration, a, mesh.extent(b), enough),
                            watched,
                            {},
                            comm);
    if (!asking.box)
      return {};
    const BoundaryFaces<dim> of_b(configuration,
                                  [&](const CellIterator<dim> &cell, const unsigned int) {
                                    return mesh.body(cell) == b;
                                  });
    const BodySurface<dim>   outside(of_b, watched, {}, comm);
    // Against the whole surface of b, not only its candidates: a point deep inside has its closest
    // faces far away.
    Overlap result = depth_inside(asking, outside, b, watched, comm);
    // Bodies at the same position have the same surfaces: the centres of the cells behind the
    // faces are tested as well.
    for (unsigned int i = 0; i < asking.places.size(); ++i)
      {
        asking.places[i] -= asking.depth(i) * asking.normals[i];
        asking.rest[i].x -= asking.depth(i) * asking.normals[i];
      }
    result.take(depth_inside(asking, outside, b, watched, comm));
    return result;
  }



#define INSTANTIATE(dim)                                                                           \
  template Overlap overlap_of(const BodySurface<dim> &,                                            \
                              const BodySurface<dim> &,                                            \
                              const MonitoredSurfaces<dim> &,                                      \
                              MPI_Comm);                                                           \
  template Overlap depth_inside(const BodySurface<dim> &,                                          \
                                const BodySurface<dim> &,                                          \
                                unsigned int,                                                      \
                                const MonitoredSurfaces<dim> &,                                    \
                                MPI_Comm);                                                         \
  template Overlap initial_depth(const Configuration<dim> &,                                       \
                                 unsigned int,                                                     \
                                 unsigned int,                                                     \
                                 const MonitoredSurfaces<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
