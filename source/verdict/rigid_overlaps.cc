// SPDX-License-Identifier: Apache-2.0
#include "verdict/overlaps.h"

namespace Signorini
{
  using namespace dealii;

  namespace
  {
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
  } // namespace



  template <int dim>
  Overlap
  overlap_of(const Configuration<dim>     &configuration,
             const BodySurface<dim>       &a,
             const Obstacle<dim>          &obstacle,
             const unsigned int            number,
             const bool                    belongs,
             const MonitoredSurfaces<dim> &watched)
  {
    // The obstacle moves as well, so that the start is evaluated with its pose at rest.
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
      return std::any_of(scene.obstacles.begin(), scene.obstacles.end(), [&](const auto &obstacle) {
        return watched.is_monitored(a.kinds[a.face_of[i]], obstacle.name) &&
               configuration.closest(obstacle, configuration.pose(obstacle), a.places[i]).gap <
                 a.depth(i);
      });
    };
    const auto closest = [&](const unsigned int i) -> std::optional<ObstaclePoint<dim>> {
      // The normal points out of the body, into its mirror image: the gap is positive in front of
      // the plane, and the normal of the obstacle that the plane stands for is the opposite one.
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



#define INSTANTIATE(dim)                                                                           \
  template Overlap overlap_of(const Configuration<dim> &,                                          \
                              const BodySurface<dim> &,                                            \
                              const Obstacle<dim> &,                                               \
                              unsigned int,                                                        \
                              bool,                                                                \
                              const MonitoredSurfaces<dim> &);                                     \
  template Overlap overlap_of(const Configuration<dim> &,                                          \
                              const BodySurface<dim> &,                                            \
                              const SymmetryPlane<dim> &,                                          \
                              unsigned int,                                                        \
                              const Scene<dim> &,                                                  \
                              const MonitoredSurfaces<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
