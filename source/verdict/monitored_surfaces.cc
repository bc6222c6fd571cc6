// SPDX-License-Identifier: Apache-2.0
#include "contact/constraints/inactive_pairs.h"
#include "verdict/undetected_penetration.h"

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  // Each pair is registered by all combinations of the boundary ids of slave and master.
  template <int dim>
  MonitoredSurfaces<dim>::MonitoredSurfaces(const Scene<dim> &scene, const Snapshot<dim> &now)
    : mesh(now.elasticity.mesh())
  {
    // A pair without any pressure detects nothing, whatever the reason is; if its surfaces
    // penetrate nevertheless, that is reported differently from a missing pair.
    const std::vector<bool> idle =
      Signorini::inactive_pairs(now.contact, now.pressure, now.pairs.size());
    for (unsigned int i = 0; i < now.pairs.size(); ++i)
      {
        const ContactPair<dim> &pair = now.pairs[i];
        // Surfaces of a pair that does not act may penetrate each other.
        const bool is_idle = idle[i] && pair.acts(now.time);
        if (!scene.obstacle_of(pair))
          // For each boundary of the pair the body on the other side, in both directions.
          for (const auto &[one, other] :
               {std::make_pair(pair.slave, pair.master), std::make_pair(pair.master, pair.slave)})
            for (const unsigned int boundary : mesh.boundary_ids(one))
              with_bodies.insert({boundary, *mesh.body_of(other)});
        for (const unsigned int slave : mesh.boundary_ids(pair.slave))
          if (scene.obstacle_of(pair))
            (is_idle ? idle_at_obstacles : at_obstacles).insert({slave, pair.master});
          else
            for (const unsigned int master : mesh.boundary_ids(pair.master))
              (pair.is_self() ? selves :
               is_idle        ? inactive_pairs :
                                pairs)
                .insert(std::minmax(slave, master));
        if (pair.is_self())
          // In self-contact the division of a surface into slave and master depends on the
          // configuration, so that the present one is stored face by face.
          for (const SlaveFace<dim> &face : now.surfaces[i].slave_faces)
            if (face.degree > 0)
              slaves.insert({face.cell, face.face});
      }
  }



  // Faces of slaves in self-contact have kinds beyond all boundary ids, so that they can be
  // distinguished from the other faces of the same boundary.
  template <int dim>
  unsigned int
  MonitoredSurfaces<dim>::kind(const CellIterator<dim> &cell, const unsigned int face) const
  {
    const bool is_slave = !slaves.empty() && slaves.count({cell->id(), face}) > 0;
    return cell->face(face)->boundary_id() + (is_slave ? mesh.end_of_boundary_ids() : 0);
  }



  template <int dim>
  bool
  MonitoredSurfaces<dim>::is_self(const unsigned int a, const unsigned int b) const
  {
    return selves.count(boundaries(a, b)) > 0;
  }



  // In self-contact only slave faces against other faces are checked by the pair.
  template <int dim>
  bool
  MonitoredSurfaces<dim>::is_monitored(const unsigned int a, const unsigned int b) const
  {
    const unsigned int end = mesh.end_of_boundary_ids();
    return pairs.count(boundaries(a, b)) > 0 || (is_self(a, b) && (a < end) != (b < end));
  }



  template <int dim>
  bool
  MonitoredSurfaces<dim>::is_monitored(const unsigned int a, const std::string &obstacle) const
  {
    return at_obstacles.count({a % mesh.end_of_boundary_ids(), obstacle}) > 0;
  }



  // Kinds are reduced to boundary ids, because a pair in self-contact concerns the whole surface.
  template <int dim>
  bool
  MonitoredSurfaces<dim>::has_pair(const unsigned int a, const unsigned int body) const
  {
    return with_bodies.count({a % mesh.end_of_boundary_ids(), body}) > 0;
  }



  // Surfaces that another pair monitors do not count.
  template <int dim>
  bool
  MonitoredSurfaces<dim>::is_inactive(const unsigned int a, const unsigned int b) const
  {
    return !is_monitored(a, b) && inactive_pairs.count(boundaries(a, b)) > 0;
  }



  template <int dim>
  bool
  MonitoredSurfaces<dim>::is_inactive(const unsigned int a, const std::string &obstacle) const
  {
    return !is_monitored(a, obstacle) &&
           idle_at_obstacles.count({a % mesh.end_of_boundary_ids(), obstacle}) > 0;
  }



  template <int dim>
  std::string
  MonitoredSurfaces<dim>::name(const unsigned int kind) const
  {
    for (const std::string &boundary : mesh.boundaries())
      if (mesh.boundary_ids(boundary).count(kind % mesh.end_of_boundary_ids()) > 0)
        return boundary;
    return "";
  }



  // The order of the two boundaries does not matter: the smaller id is the first.
  template <int dim>
  std::pair<unsigned int, unsigned int>
  MonitoredSurfaces<dim>::boundaries(const unsigned int a, const unsigned int b) const
  {
    const unsigned int end = mesh.end_of_boundary_ids();
    return std::minmax({a % end, b % end});
  }



  template class MonitoredSurfaces<2>;
  template class MonitoredSurfaces<3>;
} // namespace Signorini
