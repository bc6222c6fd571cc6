// SPDX-License-Identifier: Apache-2.0
#include "contact/search/boundary_faces.h"
#include "contact/search/search.h"
#include "contact/search/search_radius.h"
#include "fields/point_values.h"
#include "verdict/checks.h"
#include <signorini/base/text.h>
#include <signorini/solid/model.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Areas and extreme values of the contact of one pair, over all ranks.
    struct ContactExtent
    {
      /// Area of active points, and of all candidates.
      double active = 0, candidates = 0;
      /// Area and number of the faces that carry pressure.
      double touched_faces = 0, n_touched = 0;
      double smallest_reference_gap = std::numeric_limits<double>::max();
      /// Smallest cosine between the slave normal and the opposite master normal where there is
      /// pressure.
      double smallest_normal_alignment = 1;
      /// Mean penetration [length] over the active area.
      double penetration = 0;
      /// Largest overlap [length] at any integration point.
      double deepest = 0;
      // Extreme reference gaps of active points:
      double largest_reference_gap = -std::numeric_limits<double>::max(),
             least_reference_gap   = -largest_reference_gap;
      /// Largest pressure, largest stiffness times depth (a modulus), and largest penalty.
      double pressure = 0, modulus = 0, epsilon = 0;
    };

    /// @return the extent of a pair. Collective.
    template <int dim>
    ContactExtent
    contact_extent_of(const Snapshot<dim> &s, const unsigned int pair)
    {
      ContactExtent extent;
      auto          which = s.contact.origin.pair.begin();
      for (const auto i : s.active.locally_owned_elements())
        if (*which++ == pair)
          {
            // Sums and extreme values over the rows of the gap operator.
            extent.active += s.active(i) * s.contact.weight(i);
            extent.penetration -= s.active(i) * s.contact.weight(i) * std::min(0., s.gap(i));
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
      for (const auto &[number, face] : faces)
        if (face.touched)
          {
            extent.touched_faces += face.area;
            extent.n_touched += 1;
          }
      // Reduce over all ranks.
      const MPI_Comm comm = s.elasticity.mesh().communicator();
      for (double *sum : {&extent.active,
                          &extent.candidates,
                          &extent.penetration,
                          &extent.touched_faces,
                          &extent.n_touched})
        *sum = Utilities::MPI::sum(*sum, comm);
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

    /// @return the result of a check of a pair: passed up to the limit, otherwise a warning.
    CheckResult
    make_check_result(const std::string &check,
                      const std::string &pair,
                      const double       value,
                      const double       limit,
                      const std::string &message,
                      const std::string &advice)
    {
      CheckResult check_result;
      check_result.check   = check;
      check_result.where   = "pair " + pair;
      check_result.value   = value;
      check_result.limit   = limit;
      check_result.outcome = value <= limit ? Outcome::passed : Outcome::warned;
      check_result.message = message;
      check_result.advice  = advice;
      return check_result;
    }

    /// Check that a pair touches in any load step.
    CheckResult
    check_pair_active(const std::string &name, const ContactExtent &extent)
    {
      CheckResult check_result = make_check_result(
        "inactive pair",
        name,
        extent.active > 0,
        1,
        "the surfaces of this pair never touch",
        "check the initial gaps that --check prints, the signs of loads and supports, "
        "and Slave and Master of the pair");
      check_result.aggregation = CheckResult::Aggregation::best;
      check_result.outcome     = extent.active > 0 ? Outcome::passed : Outcome::warned;
      return check_result;
    }

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

    /// The deepest penetration of an obstacle into a surface.
    struct ObstacleTip
    {
      /// Depth [length], and size [length] of the face where it is deepest.
      double depth = 0, face = 0;
    };

    /// @return the deepest penetration of an obstacle, which may be so small that it is between the
    /// integration points. Collective.
    template <int dim>
    ObstacleTip
    deepest_tip(const Obstacle<dim> &obstacle, const Snapshot<dim> &s, const std::string &surface)
    {
      const Configuration<dim> configuration(s.elasticity, s.displacement);
      const BoundaryFaces<dim> faces(configuration, surface);
      const RigidPose<dim>     pose   = configuration.pose(obstacle);
      const double             length = s.elasticity.rotation_length_scale();
      const QGauss<dim - 1>    starts(2);
      ObstacleTip              tip;
      for (unsigned int i = 0; i < faces.patches.size(); ++i)
        {
          const FacePatch<dim> &face = faces.patches[i];
          if (!obstacle.shape->has_closest_point(faces.rest[i].center(), length) ||
              configuration.closest(obstacle, pose, face.center()).gap > face.diameter())
            continue;
          for (const Point<dim - 1> &xi : starts.get_points())
            if (const double depth = -gap_along_descent(configuration, obstacle, pose, face, xi);
                depth > tip.depth)
              tip = {depth, face.diameter() / std::sqrt(dim - 1.)};
        }
      const MPI_Comm comm  = s.elasticity.mesh().communicator();
      const double   depth = Utilities::MPI::max(tip.depth, comm);
      return {depth, Utilities::MPI::max(tip.depth == depth ? tip.face : 0., comm)};
    }

    /// Check for penetration without pressure: a body that touches within a face may have a
    /// positive mean gap over the face, which is all that multipliers take into account.
    CheckResult
    check_missed_penetration_of_obstacle(const std::string   &name,
                                         const ContactExtent &extent,
                                         const ObstacleTip   &tip,
                                         const double         facets)
    {
      const double depth        = std::max(0., tip.depth - facets);
      CheckResult  check_result = make_check_result(
        "penetration without pressure / face size",
        name,
        extent.active > 0 || tip.face == 0 ? 0. : depth / tip.face,
        3e-3,
        "the surfaces penetrate each other by up to " + short_text(depth, 2) +
          " within faces that carry no pressure, because the slave mesh does not resolve the master",
        "refine the slave, or exchange Slave and Master");
      check_result.aggregation = CheckResult::Aggregation::last;
      if (check_result.outcome == Outcome::warned)
        check_result.outcome = Outcome::failed;
      return check_result;
    }

    /// Check that the slave is not much stiffer or finer than the master, (3.12) of doc/theory.
    CheckResult
    check_slave_choice(const std::string &name, const Sides &sides)
    {
      return make_check_result(
        "slave choice",
        name,
        sides.pressure_error(),
        10,
        "the slave is so much stiffer or finer than the master (" + short_text(sides.modulus, 2) +
          " times as stiff, faces " + short_text(sides.size, 2) +
          " times as large) that its pressure may oscillate by a few percent",
        "refine the master, or choose the softer body as Slave (Slave choice = automatic does so if possible)");
    }

    /// Check that motions are small if contact is evaluated in the reference configuration.
    template <int dim>
    CheckResult
    check_small_sliding(const Snapshot<dim>       &s,
                        const ContactPair<dim>    &pair,
                        const Obstacle<dim>       *obstacle,
                        const std::vector<double> &displacements)
    {
      return make_check_result(
        "surface motion / model size",
        pair.name,
        largest_approach(s.elasticity, pair, obstacle, s.displacement, displacements) /
          s.elasticity.mesh().size(),
        0.1,
        "gaps and normals are those of the reference configuration (small sliding), which is wrong for "
        "sliding or rotation of this size",
        "set Contact method/Contact geometry = updated, or start with bodies that nearly touch");
    }

    /// Check the pressure that flat facets of a curved surface would cause, relative to the largest
    /// one.
    template <int dim>
    CheckResult
    check_facet_pressure(const Snapshot<dim> &s,
                         const unsigned int   pair,
                         const ContactExtent &extent)
    {
      const FacetHeight slave  = s.elasticity.mesh().facet_height(s.pairs[pair].slave),
                        master = s.elasticity.mesh().facet_height(s.pairs[pair].master);
      FacetHeight  steeper     = slave.slope() > master.slope() ? slave : master;
      const double height      = steeper.height;
      // Matching facets have no gaps between them.
      if (std::min(slave.height, master.height) > 0)
        steeper.height =
          std::min(height, std::max(0., extent.largest_reference_gap - extent.least_reference_gap));
      return make_check_result(
        "faceting error",
        s.pairs[pair].name,
        extent.pressure > 0 ? steeper.slope() * extent.modulus / extent.pressure : 0.,
        0.1,
        "flat facets approximate a curved surface: their height of up to " + short_text(height, 2) +
          " perturbs the pressure by about that fraction",
        "use smaller facets, name the surface in Curved boundaries, or use "
        "second-order elements with curved sides");
    }

    /// @return 1 at nodes with neighbours on all sides, 0 at those at the edge of the surface:
    /// there the mean of the neighbours is off the node by at least a third of their root mean
    /// square distance (on regular meshes).
    LA::Vector
    within_surface(const GapOperator &contact)
    {
      constexpr double off = 0.3;
      LA::Vector       all = contact.zero(), rest = all, offset = all, distance = all;
      all = 1.;
      for (LA::Vector x : contact.geometry.position)
        {
          x.add(-x.mean_value());
          LA::Vector squares = x;
          squares.scale(x);
          const LA::Vector mean = contact.origin.regions.means_of_neighbours(all, x, rest),
                           mean_square =
                             contact.origin.regions.means_of_neighbours(all, squares, rest);
          for (const auto i : x.locally_owned_elements())
            {
              offset(i) += std::pow(mean(i) - x(i), 2);
              distance(i) += mean_square(i) - 2 * mean(i) * x(i) + x(i) * x(i);
            }
        }
      for (const auto i : all.locally_owned_elements())
        all(i) = offset(i) < off * distance(i) ? 1. : 0.;
      all.compress(VectorOperation::insert);
      return all;
    }

    /// Check the pressure for node-to-node oscillation: the share of nodes where it alternates by
    /// more than two percent of the largest pressure. Let z be the difference of the pressure at a
    /// node from the mean of its neighbours. For an alternating pressure of amplitude a on a
    /// regular mesh z = l a, and the neighbours have -r l a in the mean, with l = 2, r = 1 along a
    /// line and l = 4/3, r = 1/3 on a surface; hence a^2 = -z z_neighbours/(l^2 r). For smooth
    /// pressures z has the same sign at neighbours, irregular meshes give any sign, and at edges,
    /// where the pressure is singular, it alternates at a few nodes only. At the edge of the
    /// surface all neighbours are on one side, so that z is a gradient: these nodes are excluded.
    /// Open nodes between active ones count with their pressure zero. Steep pressures alternate
    /// once beside an edge; therefore the neighbours have to alternate as well. Pressures of the
    /// size of rounding do not count, tensions of pairs without separation do.
    template <int dim>
    CheckResult
    check_pressure_oscillation(const Snapshot<dim> &s,
                               const unsigned int   pair,
                               const ContactExtent &extent)
    {
      constexpr double scale = dim == 2 ? 4. : 16. / 27, little = 0.02, few = 5, rounding = 1e-9;
      const bool       counts_at_all =
        extent.pressure >
        rounding * extent.modulus * s.displacement.linfty_norm() / s.elasticity.mesh().size();
      const GapOperator &contact = s.contact;
      // Nodes of other pairs do not count; open nodes all of whose neighbours are active do.
      LA::Vector active = s.active, inner = contact.zero(), innermost = contact.zero();
      auto       which = contact.origin.pair.begin();
      for (const auto i : active.locally_owned_elements())
        if (*which++ != pair)
          active(i) = 0;
      active.compress(VectorOperation::insert);
      inner = 1.; // means are requested at all nodes
      const LA::Vector of_pressed =
        contact.origin.regions.means_of_neighbours(inner, active, innermost);
      for (const auto i : active.locally_owned_elements())
        if (of_pressed(i) > 1 - 1e-9)
          active(i) = 1;
      active.compress(VectorOperation::insert);
      // The excess z of each node, and the product -z z_neighbours in the mean; nodes at the edge
      // of the surface are excluded.
      LA::Vector more = contact.origin.regions.means_of_neighbours(active, s.pressure, inner);
      inner.scale(within_surface(contact));
      more.sadd(-1, 1, s.pressure);
      LA::Vector turns   = contact.origin.regions.means_of_neighbours(inner, more, innermost),
                 ignored = inner;
      for (const auto i : more.locally_owned_elements())
        turns(i) *= -more(i);
      turns.compress(VectorOperation::insert);
      // The same product at the neighbours, which must alternate as well.
      const LA::Vector around =
        contact.origin.regions.means_of_neighbours(innermost, turns, ignored);
      const double most             = scale * std::pow(little * extent.pressure, 2);
      double       is_significant[] = {0, 0};
      for (const auto i : more.locally_owned_elements())
        if (innermost(i) > 0)
          {
            is_significant[0] += turns(i) > most && around(i) > 0;
            is_significant[1] += 1;
          }
      Utilities::MPI::sum(is_significant, s.elasticity.mesh().communicator(), is_significant);
      return make_check_result(
        "pressure oscillation",
        s.pairs[pair].name,
        counts_at_all && is_significant[1] >= few ? is_significant[0] / is_significant[1] : 0.,
        1. / 3,
        "the pressure oscillates from node to node by more than 2 % of its "
        "largest value at that fraction of the nodes",
        "exchange Slave and Master, refine the master, or choose another method");
    }

    /// Check the rounding error of the pressure, for methods whose pressure is the gap times a
    /// stiffness.
    template <int dim>
    CheckResult
    check_penalty_roundoff(const Snapshot<dim> &s,
                           const unsigned int   pair,
                           const ContactExtent &extent)
    {
      const double rounding =
        extent.epsilon * s.displacement.linfty_norm() * std::numeric_limits<double>::epsilon();
      return make_check_result(
        "penalty round-off / pressure",
        s.pairs[pair].name,
        extent.pressure > 0 ? rounding / extent.pressure : 0.,
        1e-6,
        "the penalty is so large that round-off of the displacements is visible in "
        "the pressure",
        "set a smaller Factor");
    }

    /// Check the penetration, for methods that allow one, relative to the deformation, which is
    /// estimated by the largest strain times the width of the contact area.
    template <int dim>
    CheckResult
    check_penetration(const Snapshot<dim>         &s,
                      const unsigned int           pair,
                      const ContactExtent         &extent,
                      const std::vector<Extremes> &extremes)
    {
      double strain = 0;
      for (const Extremes &body : extremes)
        strain = std::max(strain, body.gradient);
      const bool   is_plane = dim == 2 && s.elasticity.model() != Model::axisymmetric;
      const double width    = is_plane ? extent.active : std::sqrt(extent.active);
      return make_check_result(
        "penetration / deformation",
        s.pairs[pair].name,
        strain > 0             ? extent.penetration / (strain * width) :
        extent.penetration > 0 ? 1. :
                                 0.,
        0.05,
        "the penetration is not small compared with the deformation of the bodies: "
        "the relative error of pressures is about that value",
        "set a larger Factor, or choose a method with multipliers");
    }

    /// Check that there are enough faces across the contact area, unless all candidates are in
    /// contact: then its edges are those of the surfaces.
    template <int dim>
    CheckResult
    check_contact_resolution(const std::string   &name,
                             const unsigned int   degree,
                             const ContactExtent &extent)
    {
      constexpr double few = 5, whole = 0.95;
      CheckResult      check_result;
      check_result.check       = "faces across the contact area";
      check_result.where       = "pair " + name;
      check_result.aggregation = CheckResult::Aggregation::last;
      check_result.limit       = few;
      if (extent.n_touched == 0)
        return check_result;
      const double faces  = extent.active / (extent.touched_faces / extent.n_touched);
      const double across = dim == 2 ? faces : std::sqrt(faces * 4 / numbers::PI);
      check_result.value  = degree * across;
      const bool is_whole = extent.active >= whole * extent.candidates;
      check_result.outcome =
        check_result.value < few && !is_whole ? Outcome::warned : Outcome::passed;
      check_result.message =
        check_result.value < 2 ?
          "the contact area lies within one face: errors of forces and pressures may exceed 100 %" :
          "the mesh does not resolve the contact area: the error of the largest pressure may be tens of percent";
      check_result.advice =
        "refine there (Mesh/Contact refinements, Refinement regions) to 5 or more faces (degree 2: nodes) across the contact area";
      return check_result;
    }

    /// Check that most contact faces are entirely in contact. Contact zones of several faces have
    /// their edges in few of them. Where most faces are partly in contact, zones are narrower than
    /// faces, or the pressure oscillates from face to face.
    CheckResult
    check_partial_contact(const std::string &name, const ContactExtent &extent)
    {
      constexpr unsigned int few = 4; // for fewer faces see check_contact_resolution()
      CheckResult            check_result;
      check_result.check       = "contact area / area of contact faces";
      check_result.where       = "pair " + name;
      check_result.aggregation = CheckResult::Aggregation::last;
      check_result.value       = extent.n_touched > few ? extent.active / extent.touched_faces : 1.;
      check_result.limit       = 0.5;
      check_result.outcome =
        check_result.value < check_result.limit ? Outcome::warned : Outcome::passed;
      check_result.message =
        "most faces are only partly in contact: errors of areas and of the largest pressure may exceed 100 %";
      check_result.advice =
        "refine there, set Degree = 2, exchange Slave and Master, or choose another method";
      return check_result;
    }
  } // namespace



  // Inactive pairs, and pairs with negligible forces, are checked for missed contact only.
  template <int dim>
  std::vector<CheckResult>
  check_pairs(const Decisions<dim>         &decisions,
              const Snapshot<dim>          &now,
              const std::vector<Extremes>  &extremes,
              const nlohmann::ordered_json &results,
              const double                  scale)
  {
    std::vector<CheckResult>  check_results;
    const std::vector<double> displacements =
      largest_displacements(now.elasticity, now.displacement);
    for (unsigned int i = 0; i < now.pairs.size(); ++i)
      {
        const ContactPair<dim>    &pair     = now.pairs[i];
        const ContactSurface<dim> &surface  = now.surfaces[i];
        const Obstacle<dim>       *obstacle = decisions.scene.obstacle_of(pair);
        const ContactExtent        extent   = contact_extent_of(now, i);
        ObstacleTip                tip{extent.deepest, surface.face_size};
        // A rigid tip may be between the integration points of an inactive pair: search for the
        // deepest point.
        if (obstacle && extent.active == 0 && !pair.gap_is_given())
          if (const ObstacleTip deepest = deepest_tip(*obstacle, now, pair.slave);
              deepest.depth > tip.depth)
            tip = deepest;
        if (!pair.found)
          check_results.push_back(check_pair_active(pair.name, extent));
        if (pair.can_separate && pair.interference.value({}, now.time) == 1)
          check_results.push_back(check_missed_penetration_of_obstacle(
            pair.name,
            extent,
            tip,
            std::max(now.elasticity.mesh().facet_height(pair.slave).height,
                     obstacle ? 0. : now.elasticity.mesh().facet_height(pair.master).height)));
        if (extent.active == 0 ||
            !is_significant(results["pairs"][pair.name]["normal_force"], scale))
          continue;
        if (now.contact.at_rest())
          check_results.push_back(check_small_sliding(now, pair, obstacle, displacements));
        check_results.push_back(
          check_contact_resolution<dim>(pair.name, decisions.degree_of(pair.slave), extent));
        check_results.push_back(check_partial_contact(pair.name, extent));
        check_results.push_back(make_check_result(
          "initial overlap / face size",
          pair.name,
          std::max(0., -extent.smallest_reference_gap) / surface.face_size,
          1,
          "the initial overlap is larger than a face of the slave",
          "refine the slave, or apply the overlap gradually: Interference ramp = t"));
        check_results.push_back(make_check_result(
          "normal misalignment",
          pair.name,
          std::acos(std::min(1., extent.smallest_normal_alignment)) * 180 / numbers::PI,
          60,
          "the angle between the slave normal and the opposite of the master normal is too large where the surfaces touch",
          "refine there, or split the boundary"));
        check_results.push_back(check_facet_pressure(now, i, extent));
        // For quadratic elements the recovered pressure is reported, which does not oscillate.
        if (now.contact.origin.regions.has_nodes() && decisions.degree_of(pair.slave) == 1)
          check_results.push_back(check_pressure_oscillation(now, i, extent));
        if (pair.can_separate)
          check_results.push_back(check_penetration(now, i, extent, extremes));
        if (!decisions.scene.contact.chosen().has_multipliers())
          check_results.push_back(check_penalty_roundoff(now, i, extent));
        if (obstacle)
          continue;
        check_results.push_back(check_slave_choice(pair.name, surface.sides));
        if (decisions.scene.contact.chosen_name() == "direct elimination")
          check_results.push_back(make_check_result(
            "non-matching nodes",
            pair.name,
            surface.non_matching_share,
            0.01,
            "direct elimination is a node-to-surface method: where slave nodes "
            "do not coincide with master nodes, errors of the pressure exceed 10 %",
            "use matching meshes, or choose another method"));
      }
    return check_results;
  }



#define INSTANTIATE(dim)                                                                           \
  template std::vector<CheckResult> check_pairs(const Decisions<dim> &,                            \
                                                const Snapshot<dim> &,                             \
                                                const std::vector<Extremes> &,                     \
                                                const nlohmann::ordered_json &,                    \
                                                double);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
