// SPDX-License-Identifier: Apache-2.0
#include "contact/interface/pairing.h"
#include "contact/interface/surface_steps.h"
#include "contact/search/boundary_faces.h"
#include "contact/search/search.h"
#include "contact/search/search_radius.h"
#include "fields/point_values.h"
#include "geometry/cell_rule.h"
#include "verdict/pair_checks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// @return the smallest gap to an obstacle on a face that steepest descent from a parameter
    /// finds: the parameter moves against the obstacle's normal as long as the gap decreases;
    /// otherwise the step is halved, until it is below 1e-3 of the face. Infinite if the normals
    /// there do not oppose each other.
    template <int dim>
    double
    gap_along_descent(const Configuration<dim> &configuration,
                      const Obstacle<dim>      &obstacle,
                      const RigidPose<dim>     &pose,
                      const FacePatch<dim>     &face,
                      Point<dim - 1>            xi)
    {
      constexpr unsigned int most  = 40;
      constexpr double       least = 1e-3; // of the face
      const auto             at    = [&](const Point<dim - 1> &there) {
        return configuration.closest(obstacle, pose, face.position(there));
      };
      ObstaclePoint<dim> place = at(xi);
      double             step  = face.diameter();
      for (unsigned int i = 0; i < most && step > least * face.diameter(); ++i)
        {
          // The step along the face that reduces the gap most: the negative normal of the obstacle,
          // projected onto the tangents by the inverse metric.
          const auto                  tangents = face.tangents(xi);
          SymmetricTensor<2, dim - 1> metric;
          Tensor<1, dim - 1>          along;
          for (unsigned int a = 0; a < dim - 1; ++a)
            {
              along[a] = -step * (tangents[a] * place.normal);
              for (unsigned int b = a; b < dim - 1; ++b)
                metric[a][b] = tangents[a] * tangents[b];
            }
          Point<dim - 1> next = xi + invert(metric) * along;
          for (unsigned int a = 0; a < dim - 1; ++a)
            next[a] = std::clamp(next[a], 0., 1.);
          const ObstaclePoint<dim> there = at(next);
          if (there.gap < place.gap)
            {
              xi    = next;
              place = there;
            }
          else
            step /= 2;
        }
      return faces_each_other(face.normal(xi), place.normal) ? place.gap :
                                                               std::numeric_limits<double>::max();
    }

    /// Set the gaps of the undeformed bodies on this rank, by a search of the master there. In an
    /// updated geometry the gaps of the rows are those at which it was found, unless settings of
    /// the pair refer to the undeformed bodies. Collective.
    /// @param pressure at the points of the pair
    template <int dim>
    void
    find_gaps_at_rest(const Snapshot<dim>       &s,
                      const unsigned int         pair,
                      const Obstacle<dim>       *obstacle,
                      const std::vector<double> &pressure,
                      ContactExtent             &extent)
    {
      const BoundaryFaces<dim> slave(Configuration<dim>(s.elasticity), s.pairs[pair].slave);
      const auto              &points = s.surfaces[pair].points;
      // The weights tell which points carry pressure. Points of unbiased methods that are on faces
      // of the master are skipped.
      std::vector<PairedPoint<dim>> paired;
      for (std::size_t q = 0; q < points.size(); ++q)
        if (const unsigned int face = points[q].face;
            face < slave.rest.size() &&
            slave.rest[face].position(points[q].xi).distance(points[q].position) <
              1e-8 * slave.rest[face].diameter())
          paired.push_back({face, points[q].xi, pressure[q] > 0 ? 1. : 0., {}});
      const auto n_active = [&] {
        return std::count_if(paired.begin(), paired.end(), [](const auto &point) {
          return point.weight > 0;
        });
      };
      const auto                before = n_active();
      const double              radius = search_radius_of_pair(s.elasticity, s.pairs[pair], 0.);
      const std::vector<double> gaps =
        reference_gaps(s.elasticity, s.pairs[pair], obstacle, slave, radius, paired);
      const ContactExtent none;
      extent.smallest_reference_gap = none.smallest_reference_gap;
      extent.least_reference_gap    = none.least_reference_gap;
      // Points without a projection were farther away than the radius.
      extent.largest_reference_gap = n_active() < before ? radius : none.largest_reference_gap;
      for (std::size_t i = 0; i < gaps.size(); ++i)
        {
          extent.smallest_reference_gap = std::min(extent.smallest_reference_gap, gaps[i]);
          if (paired[i].weight == 0)
            continue;
          extent.least_reference_gap   = std::min(extent.least_reference_gap, gaps[i]);
          extent.largest_reference_gap = std::max(extent.largest_reference_gap, gaps[i]);
        }
    }
  } // namespace



  // Two passes: over the rows of the gap operator, which carry pressures and areas, and over the
  // points of integration, which know faces and normals. Rows of other pairs are skipped. Sums of
  // penetrations have the sign of a depth.
  template <int dim>
  ContactExtent
  contact_extent_of(const Snapshot<dim> &s, const unsigned int pair, const Obstacle<dim> *obstacle)
  {
    ContactExtent extent;
    auto          which = s.contact.origin.pair.begin();
    for (const auto i : s.active.locally_owned_elements())
      if (*which++ == pair)
        {
          // Sums and extreme values over the rows of the gap operator.
          extent.active += s.active(i) * s.contact.weight(i);
          // The overclosure of a compliant interface is no penetration.
          extent.penetration -=
            s.active(i) * s.contact.weight(i) *
            std::min(0., s.gap(i) + s.contact.coefficients.overclosure(i, s.pressure(i)).value);
          extent.candidates += s.contact.weight(i);
          extent.smallest_reference_gap =
            std::min(extent.smallest_reference_gap, s.contact.reference_gap(i));
          if (s.active(i) == 0)
            continue;
          extent.least_reference_gap =
            std::min(extent.least_reference_gap, s.contact.reference_gap(i));
          extent.largest_reference_gap =
            std::max(extent.largest_reference_gap, s.contact.reference_gap(i));
          extent.pressure = std::max(extent.pressure, std::abs(s.pressure(i)));
          extent.epsilon  = std::max(extent.epsilon, s.contact.coefficients.epsilon(i));
        }
    // Faces that carry pressure, and extreme values at the contact points, which may be deeper
    // than the rows.
    const PointValues values = point_values(s, pair);
    struct Face
    {
      double area    = 0;
      bool   touched = false;
    };
    // A face with pressure at any of its points counts as touched; its whole area is compared with
    // that of the active rows.
    std::map<unsigned int, Face> faces;
    for (std::size_t q = 0; q < values.pressure.size(); ++q)
      {
        Face &face = faces[s.surfaces[pair].points[q].face];
        face.area += s.surfaces[pair].points[q].weight;
        extent.deepest = std::max(extent.deepest, -values.gap[q]);
        face.touched |= values.pressure[q] > 0;
        const ContactPoint<dim> &point = s.surfaces[pair].points[q];
        extent.modulus                 = std::max(extent.modulus, point.stiffness * point.depth);
        if (values.pressure[q] > 0)
          extent.smallest_normal_alignment =
            std::min(extent.smallest_normal_alignment, point.normal_alignment);
      }
    // Without contact no check asks for these gaps, and the search is saved.
    const MPI_Comm comm = s.elasticity.mesh().communicator();
    if (!s.contact.at_rest() && !needs_reference_gaps(s.pairs[pair]) &&
        Utilities::MPI::sum(extent.active, comm) > 0)
      find_gaps_at_rest(s, pair, obstacle, values.pressure, extent);
    for (const auto &[number, face] : faces)
      if (face.touched)
        {
          extent.touched_faces += face.area;
          extent.n_touched += 1;
        }
    // Reduce over all ranks.
    // Number of touched faces and areas are sums, since each face belongs to one rank.
    for (double *sum : {&extent.active,
                        &extent.candidates,
                        &extent.penetration,
                        &extent.touched_faces,
                        &extent.n_touched})
      *sum = Utilities::MPI::sum(*sum, comm);
    // The integral of the penetration becomes its mean over the active area.
    if (extent.active > 0)
      extent.penetration /= extent.active;
    for (double *least : {&extent.smallest_reference_gap,
                          &extent.smallest_normal_alignment,
                          &extent.least_reference_gap})
      *least = Utilities::MPI::min(*least, comm);
    for (double *most : {&extent.largest_reference_gap,
                         &extent.deepest,
                         &extent.pressure,
                         &extent.modulus,
                         &extent.epsilon})
      *most = Utilities::MPI::max(*most, comm);
    return extent;
  }



  template <int dim>
  ObstacleTip
  deepest_tip(const Obstacle<dim> &obstacle, const Snapshot<dim> &s, const std::string &surface)
  {
    // Each face starts the descent at its Gauss points, so that two minima in one face are found.
    // Faces farther away than their own diameter cannot penetrate between these points.
    const Configuration<dim> configuration(s.elasticity, s.displacement);
    const BoundaryFaces<dim> faces(configuration, surface);
    const RigidPose<dim>     pose   = configuration.pose(obstacle);
    const double             length = s.elasticity.rotation_length_scale();
    ObstacleTip              tip;
    for (unsigned int i = 0; i < faces.patches.size(); ++i)
      {
        const FacePatch<dim> &face = faces.patches[i];
        if (!obstacle.shape->has_closest_point(faces.rest[i].center(), length) ||
            configuration.closest(obstacle, pose, face.center()).gap > face.diameter())
          continue;
        for (const Point<dim - 1> &xi : cell_rule<dim - 1>(face.reference_cell(), 2).get_points())
          if (const double depth = -gap_along_descent(configuration, obstacle, pose, face, xi);
              depth > tip.depth)
            tip = {depth, face.diameter() / std::sqrt(dim - 1.)};
      }
    const MPI_Comm comm = s.elasticity.mesh().communicator();
    // The size is that of the face with the deepest point; ranks that have less contribute zero.
    const double depth = Utilities::MPI::max(tip.depth, comm);
    return {depth, Utilities::MPI::max(tip.depth == depth ? tip.face : 0., comm)};
  }



#define INSTANTIATE(dim)                                                                           \
  template ContactExtent contact_extent_of(const Snapshot<dim> &,                                  \
                                           unsigned int,                                           \
                                           const Obstacle<dim> *);                                 \
  template ObstacleTip   deepest_tip(const Obstacle<dim> &,                                        \
                                     const Snapshot<dim> &,                                        \
                                     const std::string &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
