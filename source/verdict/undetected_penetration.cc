// SPDX-License-Identifier: Apache-2.0
#include "verdict/undetected_penetration.h"

#include "contact/search/boundary_faces.h"
#include "contact/search/deep_penetration.h"
#include "contact/search/search.h"
#include "contact/search/search_radius.h"
#include "contact/search/self_contact.h"
#include "verdict/checks.h"
#include <signorini/base/text.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Overlaps of inactive pairs that are smaller than this share of a cell are attributed to
    /// facets.
    constexpr double much_of_cell = 0.2;

    /// What a surface penetrates.
    enum class PenetrationType
    {
      /// Another surface, of the same body or another one.
      other,
      /// Another body, in which the surface is deeper than the distance to any of its surfaces that
      /// would detect it.
      body,
      /// A surface in self-contact, whose points were assigned to the same side.
      itself,
      /// An obstacle of the scene.
      obstacle,
      /// A plane of symmetry of its own body, behind which is the mirror image.
      symmetry
    };

    /// Share of a cell up to which a penetration passes.
    constexpr double small = 0.02;

    /// The deepest penetration; penetrations that make the solution invalid have priority over
    /// others.
    struct Overlap
    {
      /// Depth relative to the cells behind the faces, and as a length.
      double share = 0, depth = 0;
      /// Kind of the surface, see MonitoredSurfaces.
      unsigned int    surface          = 0;
      PenetrationType penetration_type = PenetrationType::other;
      /// Kind of the other surface, or index of the body, obstacle or plane.
      unsigned int what = 0;
      /// Whether there is a pair, which has not detected it.
      bool is_inactive = false;
      /// Whether it exists in the reference configuration.
      bool at_start = false;

      /// @return whether the penetration makes the solution invalid.
      bool
      fails() const
      {
        return share > small && (penetration_type == PenetrationType::itself || is_inactive ||
                                 (at_start && penetration_type == PenetrationType::body));
      }

      /// Replace this penetration by another one if that is more severe.
      void
      take(const Overlap &other)
      {
        if (other.fails() != fails())
          {
            if (other.fails())
              *this = other;
            return;
          }
        // Of those of equal depth up to rounding the first, so that the result does not depend on
        // the partition.
        const bool is_alike = std::abs(other.share - share) <= 1e-6 * share;
        if (is_alike ? std::tie(other.surface, other.what) < std::tie(surface, what) :
                       other.share > share)
          *this = other;
      }
    };

    /// The current surface of one body, and sample points on it that are tested; at small strain
    /// only faces that may penetrate something have points.
    template <int dim>
    struct BodySurface
    {
      /// Sample the faces. Collective.
      BodySurface(const BoundaryFaces<dim>                        &of_body,
                  const MonitoredSurfaces<dim>                    &watched,
                  const std::optional<PenetrationCandidates<dim>> &near,
                  const MPI_Comm                                   comm)
        : faces(of_body)
      {
        // Sample points are the 2-point Gauss points of each face, so that points on common edges
        // of two faces are avoided.
        const QGauss<dim - 1> inner(2);
        for (unsigned int i = 0; i < faces.faces.size(); ++i)
          {
            const auto &[cell, face] = faces.faces[i];
            kinds.push_back(watched.kind(cell, face));
            const FacePatch<dim> &patch = faces.patches[i];
            deepest                     = std::max(deepest, faces.depth(i));
            if (near && !near->may_penetrate(cell, face))
              continue;
            for (const Point<dim - 1> &xi : inner.get_points())
              {
                places.push_back(patch.position(xi));
                normals.push_back(patch.normal(xi));
                rest.push_back(reference_point(faces.rest[i], xi));
                face_of.push_back(i);
              }
          }
        deepest = Utilities::MPI::max(deepest, comm);
        if (deepest > 0)
          box = box_of(faces.patches, comm);
      }

      /// @return the depth up to which penetrations are detected at a sample point: beyond half a
      /// cell the opposite side may have been passed.
      double
      depth(const unsigned int place) const
      {
        return faces.depth(face_of[place]) / 2;
      }

      /// @return the faces as master surfaces for a closest-point search.
      /// @param know_rest whether reference positions are included, by which self-contact excludes
      /// neighbours
      MasterFaces<dim>
      masters(const bool know_rest) const
      {
        const auto tell =
          [this](unsigned int i, const Point<dim - 1> &, MasterProjection<dim> &master_point) {
            master_point.kind = kinds[i];
            master_point.size = faces.depth(i) / 2;
          };
        MasterFaces<dim> result{faces.patches, tell, {}, {}};
        if (know_rest)
          result.rest = faces.rest;
        return result;
      }

      /// @return the faces in the reference configuration as master surfaces.
      MasterFaces<dim>
      reference_masters() const
      {
        const auto tell = [](unsigned int, const Point<dim - 1> &, MasterProjection<dim> &) {};
        return {faces.rest, tell, {}, {}};
      }

      BoundaryFaces<dim> faces;
      /// Kind of each face.
      std::vector<unsigned int>        kinds;
      std::vector<Point<dim>>          places;
      std::vector<Tensor<1, dim>>      normals;
      std::vector<ReferencePoint<dim>> rest;
      std::vector<unsigned int>        face_of;
      double                           deepest = 0;
      /// Bounding box of all ranks; none if there are no faces.
      std::optional<BoundingBox<dim>> box;
    };

    /// @return the surfaces of all bodies. Collective.
    template <int dim>
    std::vector<BodySurface<dim>>
    body_surfaces(const Configuration<dim>                        &configuration,
                  const MonitoredSurfaces<dim>                    &watched,
                  const std::optional<PenetrationCandidates<dim>> &near)
    {
      const Mesh<dim>              &mesh = configuration.elasticity().mesh();
      const BoundaryFaces<dim>      all(configuration,
                                   [&](const CellIterator<dim> &cell, const unsigned int face) {
                                     return !near || near->counts(cell, face);
                                   });
      std::vector<BodySurface<dim>> result;
      for (unsigned int body = 0; body < mesh.n_bodies(); ++body)
        {
          std::vector<bool> is_its(all.faces.size());
          for (unsigned int i = 0; i < is_its.size(); ++i)
            is_its[i] = mesh.body(all.faces[i].first) == body;
          result.emplace_back(all.among(is_its), watched, near, mesh.communicator());
        }
      return result;
    }

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

    /// @return the deepest penetration of sample points of a behind the closest faces of b (which
    /// may be the same body), where no active pair detects contact. Collective.
    template <int dim>
    Overlap
    overlap_of(const BodySurface<dim>       &a,
               const BodySurface<dim>       &b,
               const MonitoredSurfaces<dim> &watched,
               const MPI_Comm                comm)
    {
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

    /// @return the deepest sample point of a that was outside of b in the reference configuration
    /// and is now deeper inside than half a cell; or that has been inside from the start, unless
    /// there is a pair with that body, whose overlap may have to remain for a while. Collective.
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
      const auto   ends    = b.box->get_boundary_points();
      const double far     = ends.first.distance(ends.second);
      const auto   now     = depths(places, b.masters(false), far, comm),
                 before    = depths(at_rest, b.reference_masters(), far, comm);
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
          if (at_start ?
                is_inside(now[k], much_of_cell * cell) && !watched.has_pair(kind, body) :
                is_inside(now[k], cell / 2) && !(before[k] > 0 && std::isfinite(before[k])))
            largest.take(
              {now[k] / cell, now[k], kind, PenetrationType::body, body, false, at_start});
        }
      return largest;
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

    /// @return the deepest penetration of two bodies that overlap from the start by more than their
    /// surfaces can detect. Some faces are tested, since others beside them are as deep.
    /// Collective.
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
      Overlap                  result = depth_inside(asking, outside, b, watched, comm);
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

    /// @return the deepest penetration into something rigid. Points that were outside in the
    /// reference configuration have penetrated, at any depth; points that were inside may belong
    /// there.
    /// @param closest function that returns the closest point of the rigid surface to sample point
    /// i, or none
    /// @param was_outside whether sample point i was outside in the reference configuration
    /// @param is_inactive whether, for a kind of faces, there is a pair that has not detected
    /// contact
    /// @param belongs whether points that are inside in the reference configuration may be there
    template <int dim, typename Closest, typename WasOutside, typename IsIdle>
    Overlap
    overlap_with_rigid(const BodySurface<dim> &a,
                       const PenetrationType   penetration_type,
                       const unsigned int      what,
                       const Closest          &closest,
                       const WasOutside       &was_outside,
                       const IsIdle           &is_inactive,
                       const bool              belongs)
    {
      Overlap largest;
      for (unsigned int i = 0; i < a.places.size(); ++i)
        {
          const std::optional<ObstaclePoint<dim>> place = closest(i);
          if (!place || place->gap >= 0)
            continue;
          const unsigned int kind  = a.kinds[a.face_of[i]];
          const double       share = -place->gap / (2 * a.depth(i));
          // Shallow penetrations count if the normals are opposite; others if the point was outside
          // in the reference configuration, or deep inside of something without a pair.
          const bool idle = is_inactive(kind),
                     is_near =
                       (idle || share < 0.5) && faces_each_other<dim>(a.normals[i], place->normal);
          const bool at_start = !belongs && share >= much_of_cell && !was_outside(i);
          if ((is_near || at_start || was_outside(i)) && !(idle && share < much_of_cell))
            largest.take({share, -place->gap, kind, penetration_type, what, idle, at_start});
        }
      return largest;
    }

    /// @return the deepest penetration of a surface into an obstacle.
    template <int dim>
    Overlap
    overlap_of(const Configuration<dim>     &configuration,
               const BodySurface<dim>       &a,
               const Obstacle<dim>          &obstacle,
               const unsigned int            number,
               const bool                    belongs,
               const MonitoredSurfaces<dim> &watched)
    {
      const Configuration<dim> at_rest(configuration.elasticity());
      const RigidPose<dim>     pose = configuration.pose(obstacle), rest = at_rest.pose(obstacle);
      const double             length = configuration.elasticity().rotation_length_scale();
      // Points of monitored surfaces are left to their pair.
      const auto closest = [&](const unsigned int i) -> std::optional<ObstaclePoint<dim>> {
        if (watched.is_monitored(a.kinds[a.face_of[i]], obstacle.name) ||
            !obstacle.shape->has_closest_point(a.rest[i].x, length))
          return {};
        return configuration.closest(obstacle, pose, a.places[i]);
      };
      const auto was_outside = [&](const unsigned int i) {
        return at_rest.closest(obstacle, rest, a.rest[i].x).gap >= 0;
      };
      return overlap_with_rigid(
        a,
        PenetrationType::obstacle,
        number,
        closest,
        was_outside,
        [&](const unsigned int kind) { return watched.is_inactive(kind, obstacle.name); },
        belongs);
    }

    template <int dim>
    Overlap
    overlap_of(const Configuration<dim>     &configuration,
               const BodySurface<dim>       &a,
               const SymmetryPlane<dim>     &plane,
               const unsigned int            number,
               const Scene<dim>             &scene,
               const MonitoredSurfaces<dim> &watched)
    {
      // Where an obstacle represents the other half, penalty methods let the surface penetrate it.
      const auto is_held = [&](const unsigned int i) {
        return std::any_of(
          scene.obstacles.begin(), scene.obstacles.end(), [&](const auto &obstacle) {
            return watched.is_monitored(a.kinds[a.face_of[i]], obstacle.name) &&
                   configuration.closest(obstacle, configuration.pose(obstacle), a.places[i]).gap <
                     a.depth(i);
          });
      };
      const auto closest = [&](const unsigned int i) -> std::optional<ObstaclePoint<dim>> {
        const double gap = (plane.center - a.places[i]) * plane.normal;
        if (gap >= 0 || is_held(i))
          return {};
        return ObstaclePoint<dim>{gap, -plane.normal};
      };
      const auto was_outside = [&](const unsigned int i) {
        return (plane.center - a.rest[i].x) * plane.normal >= 0;
      };
      return overlap_with_rigid(
        a,
        PenetrationType::symmetry,
        number,
        closest,
        was_outside,
        [](unsigned int) { return false; },
        true);
    }

    /// @return the most severe penetration of all ranks. Collective.
    Overlap
    largest_of(const Overlap &own, const MPI_Comm comm)
    {
      Overlap largest;
      for (const Overlap &of_rank : Utilities::MPI::all_gather(comm, own))
        largest.take(of_rank);
      return largest;
    }
  } // namespace



  // At finite strain all surfaces are tested, at small strain the candidates only. The most severe
  // penetration is reported.
  template <int dim>
  CheckResult
  check_undetected_penetration(const Scene<dim> &scene, const Snapshot<dim> &now)
  {
    const Mesh<dim>                          &mesh             = now.elasticity.mesh();
    const bool                                is_finite_strain = now.elasticity.is_finite_strain();
    const Configuration<dim>                  configuration(now.elasticity, now.displacement);
    const MonitoredSurfaces<dim>              watched(scene, now);
    std::optional<PenetrationCandidates<dim>> near;
    if (!is_finite_strain)
      near.emplace(scene, configuration, watched);
    const auto                      bodies = body_surfaces(configuration, watched, near);
    std::vector<SymmetryPlane<dim>> planes;
    if (is_finite_strain)
      planes = symmetry_planes(scene, now.elasticity);
    Overlap largest;
    for (unsigned int body = 0; body < bodies.size(); ++body)
      {
        const BodySurface<dim> &a = bodies[body];
        for (unsigned int other = 0; other < bodies.size(); ++other)
          {
            // Each ordered pair of bodies: overlap from the start, overlap of surfaces, and, at
            // finite strain, points deep inside.
            const BodySurface<dim> &b = bodies[other];
            if (body != other)
              largest.take(initial_depth(configuration, body, other, watched));
            if ((!is_finite_strain && &a == &b) || !a.box || !b.box ||
                a.box->get_neighbor_type(*b.box) == NeighborType::not_neighbors)
              continue;
            largest.take(overlap_of(a, b, watched, mesh.communicator()));
            if (is_finite_strain && &a != &b) // else not all of the other one is there
              largest.take(depth_inside(a, b, other, watched, mesh.communicator()));
          }
        for (unsigned int i = 0; i < scene.obstacles.size(); ++i)
          {
            // An obstacle that supports another body may have a hole for this one.
            const Obstacle<dim> &obstacle = scene.obstacles[i];
            const bool           is_used =
              std::any_of(now.pairs.begin(), now.pairs.end(), [&](const ContactPair<dim> &pair) {
                return scene.obstacle_of(pair) == &obstacle;
              });
            largest.take(overlap_of(configuration, a, obstacle, i, is_used, watched));
          }
        for (unsigned int i = 0; i < planes.size(); ++i)
          if (planes[i].body == body)
            largest.take(overlap_of(configuration, a, planes[i], i, scene, watched));
      }
    largest = largest_of(largest, mesh.communicator());
    CheckResult check_result;
    // The report names the surface and what it penetrates.
    check_result.check      = "undetected contact";
    check_result.value      = largest.share;
    check_result.limit      = small;
    check_result.outcome    = largest.fails()        ? Outcome::failed :
                              largest.share <= small ? Outcome::passed :
                                                       Outcome::warned;
    const std::string name  = "'" + watched.name(largest.surface) + "' penetrates ",
                      depth = " by up to " + short_text(largest.depth, 2);
    const auto pair         = [&](const std::string &master) {
      return "add a pair with Slave = " + watched.name(largest.surface) + ", Master = " + master +
             " to Contact pairs if these surfaces can touch";
    };
    switch (largest.penetration_type)
      {
        case PenetrationType::body:
          check_result.message =
            "'" + watched.name(largest.surface) + "' is inside of '" +
            mesh.body_name(largest.what) + "', by up to " + short_text(largest.depth, 2) +
            (largest.at_start ? ", already at the start, where no pair detects contact" : "");
          check_result.advice =
            largest.at_start ?
              "add a pair of their surfaces to Contact pairs, or move the bodies apart" :
              "use smaller load steps, and add a pair to Contact pairs if there is none";
          break;
        case PenetrationType::other:
          check_result.message = name + "'" + watched.name(largest.what) + "'" + depth +
                                 ", where no pair detects contact";
          check_result.advice = pair(watched.name(largest.what));
          break;
        case PenetrationType::itself:
          check_result.message =
            name + "itself" + depth +
            ": the normals there vary so much that slave and master cannot be assigned";
          check_result.advice = "split the boundary there, and define a contact pair of its parts";
          break;
        case PenetrationType::obstacle:
          check_result.message = name + "the obstacle '" + scene.obstacles[largest.what].name +
                                 "'" + depth + (largest.at_start ? ", from the start" : "") +
                                 ", where no pair detects contact";
          check_result.advice = pair(scene.obstacles[largest.what].name);
          break;
        case PenetrationType::symmetry:
          check_result.message = name + "the plane of symmetry '" + planes[largest.what].boundary +
                                 "'" + depth + ", where it would touch its mirror image";
          check_result.advice =
            "if it is a plane of symmetry, add the plane to Obstacles and a contact pair with it";
          break;
      }
    if (largest.is_inactive)
      {
        const std::string words = ", where no pair detects contact";
        check_result.message.replace(check_result.message.find(words),
                                     words.size(),
                                     ", and their contact pair did not detect it");
        check_result.advice = "use smaller load steps, or set Search distance of the pair";
      }
    return check_result;
  }



  template CheckResult
  check_undetected_penetration(const Scene<2> &, const Snapshot<2> &);
  template CheckResult
  check_undetected_penetration(const Scene<3> &, const Snapshot<3> &);
} // namespace Signorini
