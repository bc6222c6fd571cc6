// SPDX-License-Identifier: Apache-2.0
#include "contact/interface/geometry_change.h"

#include "contact/constraints/gap_increments.h"
#include "contact/search/boundary_faces.h"
#include "contact/search/self_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Contact points with the contact force at each of them [force].
    template <int dim>
    using LoadedContactPoints = std::vector<std::pair<const ContactPoint<dim> *, double>>;

    /// Gap [length] and unit normal at the projection of a point.
    template <int dim>
    struct Facing
    {
      double         gap;
      Tensor<1, dim> normal;
    };

    /// The projections of loaded points on an obstacle. @param slave in the current configuration
    template <int dim>
    std::vector<std::optional<Facing<dim>>>
    on_obstacle(const Configuration<dim>       &now,
                const Obstacle<dim>            &obstacle,
                const BoundaryFaces<dim>       &slave,
                const LoadedContactPoints<dim> &points)
    {
      const RigidPose<dim>                    pose = now.pose(obstacle);
      std::vector<std::optional<Facing<dim>>> result;
      for (const auto &[point, force] : points)
        {
          const auto there = now
                               .partner(obstacle,
                                        pose,
                                        slave.patches[point->face],
                                        slave.rest[point->face],
                                        point->xi)
                               .first;
          result.push_back(Facing<dim>{there.gap, there.normal});
        }
      return result;
    }

    /// The projections of loaded points on the master body in the displaced configuration, within
    /// one slave face; empty where there is none. Collective.
    template <int dim>
    std::vector<std::optional<Facing<dim>>>
    on_body(const Configuration<dim>       &now,
            const ContactPair<dim>         &pair,
            const BoundaryFaces<dim>       &slave,
            const LoadedContactPoints<dim> &points,
            const MPI_Comm                  comm)
    {
      // Within one slave face the surfaces of a pair that touches have a projection; what is
      // farther away counts as lost.
      const auto                       master = BoundaryFaces<dim>::of_master(now, pair);
      std::vector<Point<dim>>          positions;
      std::vector<Tensor<1, dim>>      normals;
      std::vector<ReferencePoint<dim>> rest;
      double                           farthest = 0;
      for (const auto &[point, force] : points)
        {
          const FacePatch<dim> &patch = slave.patches[point->face];
          positions.push_back(patch.position(point->xi));
          normals.push_back(patch.normal(point->xi));
          farthest = std::max(farthest, patch.diameter());
          if (pair.is_self())
            rest.push_back(reference_point(slave.rest[point->face], point->xi));
        }
      MasterFaces<dim> faces = all_faces_as_masters(master);
      if (!pair.is_self())
        faces.rest.clear();
      std::vector<std::optional<Facing<dim>>> result;
      const auto                              master_points = find_master_projections(
        positions, normals, faces, Utilities::MPI::max(farthest, comm), comm, nullptr, {}, rest);
      for (std::size_t i = 0; i < master_points.size(); ++i)
        if (master_points[i])
          result.push_back(
            Facing<dim>{(positions[i] - master_points[i]->position) * master_points[i]->normal,
                        master_points[i]->normal});
        else
          result.emplace_back();
      return result;
    }

    /// True if a point is at the rim of its face. Nodes at the rims of a slave and a master that
    /// are flush lose their projection with the slightest sliding; they do not count as lost.
    template <int dim>
    bool
    is_on_rim(const Point<dim - 1> &xi)
    {
      for (unsigned int d = 0; d < dim - 1; ++d)
        if (std::min(xi[d], 1 - xi[d]) < 1e-6)
          return true;
      return false;
    }
  } // namespace



  // Mean square of the errors of gap and normal over the contact force, and from them the change of
  // the pressure (doc/theory, (5.21)). All sums are over all ranks.
  template <int dim>
  GeometryChange
  geometry_change(const Configuration<dim>  &now,
                  const ContactPair<dim>    &pair,
                  const Obstacle<dim>       *obstacle,
                  const ContactSurface<dim> &surface,
                  const std::vector<double> &forces)
  {
    // Only points under pressure, on faces of the pair's own slave: an unbiased method has the
    // others too.
    const MPI_Comm           comm = now.elasticity().mesh().communicator();
    LoadedContactPoints<dim> points;
    for (std::size_t i = 0; i < forces.size(); ++i)
      if (forces[i] > 0 && surface.points[i].face < surface.own_faces)
        points.emplace_back(&surface.points[i], forces[i]);
    if (Utilities::MPI::sum(points.size(), comm) == 0)
      return {};
    const BoundaryFaces<dim> slave(now, pair.slave);
    const auto               there = obstacle ? on_obstacle(now, *obstacle, slave, points) :
                                                on_body(now, pair, slave, points, comm);
    std::vector<const ContactPoint<dim> *> places;
    for (const auto &[point, force] : points)
      places.push_back(point);
    const std::vector<double> opened = gap_increments(places, now.displacement());

    std::vector<double> sums(6, 0.); // force, area, modulus, gap^2, angle^2, without projection
    for (std::size_t i = 0; i < points.size(); ++i)
      {
        const auto &[point, force] = points[i];
        sums[0] += force;
        sums[1] += point->weight;
        sums[2] += force * point->stiffness * point->depth;
        if (there[i])
          {
            // Error of the linearised gap: true gap minus g_0 + B u.
            const double gap = there[i]->gap + point->prescribed_gap - (point->gap + opened[i]);
            sums[3] += force * gap * gap;
            sums[4] += force * (there[i]->normal - point->normal).norm_square();
          }
        else if (!is_on_rim<dim>(point->xi))
          sums[5] += force;
      }
    Utilities::MPI::sum(sums, comm, sums);
    // The width of the contact area, its mean modulus and mean pressure are the scales of the
    // error: modulus times gap over width is the pressure that the error of the gap causes.
    const double width = std::pow(sums[1], 1. / (dim - 1)), modulus = sums[2] / sums[0],
                 pressure = sums[0] / sums[1];
    // A pressure that is rounding beside the modulus does not measure anything.
    if (pressure < std::numeric_limits<double>::epsilon() * modulus)
      return {};
    // Points at rims lose their projection at once, although pressures are largest there: a small
    // share of the force is disregarded.
    constexpr double at_rims = 0.02;
    GeometryChange   result;
    result.gap      = std::sqrt(sums[3] / sums[0]);
    result.angle    = std::sqrt(sums[4] / sums[0]);
    result.pressure = result.angle / 2 + modulus * result.gap / (width * pressure) +
                      std::max(0., sums[5] / sums[0] - at_rims);
    return result;
  }



#define INSTANTIATE(dim)                                                                           \
  template GeometryChange geometry_change(const Configuration<dim> &,                              \
                                          const ContactPair<dim> &,                                \
                                          const Obstacle<dim> *,                                   \
                                          const ContactSurface<dim> &,                             \
                                          const std::vector<double> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
