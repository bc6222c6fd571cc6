// SPDX-License-Identifier: Apache-2.0
#include "verdict/pair_checks.h"

#include "contact/search/search_radius.h"
#include <signorini/base/text.h>
#include <signorini/solid/model.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  // The value NaN is not below any limit, so that it gives a warning.
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
    check_result.where   = pair.empty() ? "" : "pair " + pair;
    check_result.value   = value;
    check_result.limit   = limit;
    check_result.outcome = value <= limit ? Outcome::passed : Outcome::warned;
    check_result.message = message;
    check_result.advice  = advice;
    return check_result;
  }



  namespace
  {
    /// Check that a pair touches in any load step.
    /// A pair that touches in one load step is in order, so that the best step is reported.
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

    /// Check for penetration without pressure: a body that touches within a face may have a
    /// positive mean gap over the face, which is all that multipliers take into account.
    CheckResult
    check_missed_penetration_of_obstacle(const std::string   &name,
                                         const ContactExtent &extent,
                                         const ObstacleTip   &tip,
                                         const double         facets)
    {
      // Depths up to the height of facets are no penetration of the true surfaces.
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
      // Without any pressure the solution lacks the contact altogether: this is no question of
      // accuracy.
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
      // The surface whose facets are steeper perturbs the gap more.
      FacetHeight  steeper = slave.slope() > master.slope() ? slave : master;
      const double height  = steeper.height;
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

    /// Check the rounding error of the pressure, for methods whose pressure is the gap times a
    /// stiffness.
    /// Displacements have a relative error of about 1e-16 in double precision. Multiplied by the
    /// penalty it is an error of the pressure.
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
    /// estimated by the largest strain times the width of the contact area. Where supports
    /// prescribe the normal displacement of slave nodes, cells beside them are compressed by what
    /// is prescribed minus the penetration: then it is the strain times the depth of a cell.
    /// Collective.
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
      const bool is_plane = dim == 2 && s.elasticity.model() != Model::axisymmetric;
      // The contact area is a length in plane models; otherwise its root is taken as the width.
      double width = is_plane ? extent.active : std::sqrt(extent.active);
      if (s.surfaces[pair].has_dirichlet_nodes)
        {
          for (const ContactPoint<dim> &point : s.surfaces[pair].points)
            width = std::min(width, point.depth);
          width = Utilities::MPI::min(width, s.elasticity.mesh().communicator());
        }
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
      // The active area in units of the mean area of a touched face. In space the diameter of the
      // disc of that area counts, in the plane the length. Quadratic elements have two nodes for
      // each face.
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
      // Of a few faces most are at an edge of the contact area, so that the share says nothing.
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

    /// Check that the initial overlap is within a face.
    CheckResult
    check_initial_overlap(const std::string   &name,
                          const ContactExtent &extent,
                          const double         face_size)
    {
      return make_check_result(
        "initial overlap / face size",
        name,
        std::max(0., -extent.smallest_reference_gap) / face_size,
        1,
        "the initial overlap is larger than a face of the slave",
        "refine the slave, or apply the overlap gradually: Interference ramp = t");
    }

    /// Check that the surfaces face each other where they touch.
    CheckResult
    check_alignment(const std::string &name, const ContactExtent &extent)
    {
      return make_check_result(
        "normal misalignment",
        name,
        std::acos(std::min(1., extent.smallest_normal_alignment)) * 180 / dealii::numbers::PI,
        60,
        "the angle between the slave normal and the opposite of the master normal is too large where the surfaces touch",
        "refine there, or split the boundary");
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
    const bool is_nodal = decisions.scene.contact.chosen_name() == "direct elimination";
    std::vector<CheckResult>  check_results;
    const std::vector<double> displacements =
      largest_displacements(now.elasticity, now.displacement);
    // All calls that communicate are made for each pair on all ranks alike, since their conditions
    // are reduced values.
    for (unsigned int i = 0; i < now.pairs.size(); ++i)
      {
        const ContactPair<dim>    &pair     = now.pairs[i];
        const ContactSurface<dim> &surface  = now.surfaces[i];
        const Obstacle<dim>       *obstacle = decisions.scene.obstacle_of(pair);
        const ContactExtent        extent   = contact_extent_of(now, i, obstacle);
        ObstacleTip                tip{extent.deepest, surface.face_size};
        // A rigid tip may be between the integration points of an inactive pair: search for the
        // deepest point.
        if (obstacle && extent.active == 0 && !pair.gap_is_given())
          if (const ObstacleTip deepest = deepest_tip(*obstacle, now, pair.slave);
              deepest.depth > tip.depth)
            tip = deepest;
        if (!pair.acts(now.time))
          continue;
        if (!pair.found)
          check_results.push_back(check_pair_active(pair.name, extent));
        // While an initial overlap is applied gradually, part of it is penetration on purpose.
        if (pair.can_separate && pair.interference.value({}, now.time) == 1)
          check_results.push_back(check_missed_penetration_of_obstacle(
            pair.name,
            extent,
            tip,
            std::max(now.elasticity.mesh().facet_height(pair.slave).height,
                     obstacle ? 0. : now.elasticity.mesh().facet_height(pair.master).height)));
        // Tied surfaces neither slide nor have an edge of contact.
        if (pair.is_tied)
          {
            const auto &its = results["pairs"][pair.name];
            for (const CheckResult &one : check_tie(now, i, is_nodal && !obstacle, its))
              check_results.push_back(one);
            if (now.contact.at_rest() && pair.strength.given() && its["bond"]["failed_share"] > 0.)
              check_results.push_back(check_small_sliding(now, pair, obstacle, displacements));
            continue;
          }
        if (extent.active == 0 ||
            !is_significant(results["pairs"][pair.name]["normal_force"], scale))
          continue;
        // Updated contact geometry has no restriction on sliding.
        if (now.contact.at_rest())
          check_results.push_back(check_small_sliding(now, pair, obstacle, displacements));
        check_results.push_back(
          check_contact_resolution<dim>(pair.name, decisions.degree_of(pair.slave), extent));
        check_results.push_back(check_partial_contact(pair.name, extent));
        check_results.push_back(check_initial_overlap(pair.name, extent, surface.face_size));
        check_results.push_back(check_alignment(pair.name, extent));
        check_results.push_back(check_facet_pressure(now, i, extent));
        // For quadratic elements the recovered pressure is reported, which does not oscillate.
        if (now.contact.origin.regions.has_nodes() && decisions.degree_of(pair.slave) == 1)
          check_results.push_back(check_pressure_oscillation(now, i, extent));
        if (pair.can_separate)
          check_results.push_back(check_penetration(now, i, extent, extremes));
        if (!decisions.scene.contact.chosen().has_multipliers())
          check_results.push_back(check_penalty_roundoff(now, i, extent));
        if (!pair.friction.is_zero())
          for (const CheckResult &one : check_friction(pair.name,
                                                       results["pairs"][pair.name],
                                                       extent,
                                                       surface.face_size,
                                                       now.step * now.parts))
            check_results.push_back(one);
        if (obstacle)
          continue;
        check_results.push_back(check_slave_choice(pair.name, surface.sides));
        if (is_nodal)
          check_results.push_back(check_matching_nodes(pair.name, surface.non_matching_share));
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
