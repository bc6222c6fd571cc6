// SPDX-License-Identifier: Apache-2.0
#include "verdict/checks.h"

#include "fields/peak.h"
#include "verdict/pair_checks.h"
#include <signorini/solid/model.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
  bool
  is_significant(const double force, const double scale)
  {
    constexpr double rounding = 1e-9;
    return force > rounding * scale;
  }



  // The worst body is reported; values are relative to the scale instead of the largest force of
  // this step.
  std::vector<CheckResult>
  check_balance(const nlohmann::ordered_json &results, const double scale, const double small)
  {
    // Newton's method ends at 1e-10 or less; linear solvers for stiff bodies beside soft ones, and
    // geometry that is not exact for rotations, leave more.
    struct Bounds
    {
      const char *check, *key;
      double      warned, failed;
    };
    // Balances in results.json are relative to the largest force of the step; here they refer to
    // the scale, which is that of all load steps, so that an unloaded step does not fail by
    // rounding.
    const double             largest = results["largest_force"];
    std::vector<CheckResult> check_results;
    for (const auto &[check, key, warned, failed] :
         {Bounds{"force balance", "force_balance", small, 0.1},
          Bounds{"moment balance", "moment_balance", std::max(small, 1e-3), 0.1}})
      {
        CheckResult check_result;
        check_result.check = check;
        for (const auto &[body, of_body] : results["bodies"].items())
          if (const double value = scale > 0 ? of_body[key].get<double>() * largest / scale : 0.;
              // The negated comparison also reports NaN.
              !(value <= check_result.value))
            {
              check_result.value = value;
              check_result.where = "body " + body;
            }
        check_result.limit   = warned;
        check_result.outcome = check_result.value <= warned ? Outcome::passed :
                               check_result.value <= failed ? Outcome::warned :
                                                              Outcome::failed;
        check_result.message =
          "the forces or moments on the body are not in balance; the value is relative to the largest force";
        check_result.advice =
          "set a smaller Newton/Tolerance or Solver/Preconditioner = direct; for moments, refine the mesh";
        check_results.push_back(check_result);
      }
    return check_results;
  }



  namespace
  {
    /// Check that the resultant of the pressures is not larger than their integral, as it must be
    /// if they are compressive. Tangential tractions are left out.
    std::vector<CheckResult>
    check_normal_forces(const nlohmann::ordered_json &results, const double scale)
    {
      // The resultant is a vector sum of p n dA and cannot be longer than the integral of p. A
      // percent is left to quadrature and to normals that are no unit vectors in the mean.
      constexpr double         exact = 1.01, none = 1.05;
      std::vector<CheckResult> check_results;
      for (const auto &[name, pair] : results["pairs"].items())
        {
          if (!pair["separates"].get<bool>())
            continue;
          // Pairs without separation transfer tension, for which the inequality does not hold.
          double square = 0;
          for (unsigned int d = 0; d < pair["force"].size(); ++d)
            {
              const double friction =
                pair.contains("friction_force") ? pair["friction_force"][d].get<double>() : 0.;
              square += std::pow(pair["force"][d].get<double>() - friction, 2);
            }
          const double normal = pair["normal_force"], force = std::sqrt(square);
          CheckResult  check_result;
          check_result.check   = "contact force / normal force";
          check_result.where   = "pair " + name;
          check_result.value   = !is_significant(force, scale) ? 0. :
                                 normal > 0                    ? force / normal :
                                                                 2 * none;
          check_result.limit   = exact;
          check_result.outcome = check_result.value <= exact ? Outcome::passed :
                                 check_result.value <= none  ? Outcome::warned :
                                                               Outcome::failed;
          check_result.message =
            "the resultant contact force exceeds the integral of the pressure, which is impossible: faces are too coarse for this contact, or hardly covered by the master";
          check_result.advice = "refine the slave, or exchange Slave and Master";
          check_results.push_back(check_result);
        }
      return check_results;
    }

    /// Check that pressure peaks are resolved, see sharpness_of_peak().
    std::vector<CheckResult>
    check_peaks(const nlohmann::ordered_json &results, const double scale)
    {
      std::vector<CheckResult> check_results;
      for (const auto &[name, pair] : results["pairs"].items())
        {
          CheckResult check_result;
          check_result.check = "pressure peak resolution";
          check_result.where = "pair " + name;
          // Pairs without force have no peak.
          check_result.value       = is_significant(pair["normal_force"], scale) ?
                                       pair["sharpness_of_peak"].get<double>() :
                                       0.;
          check_result.limit       = sharp_peak;
          check_result.aggregation = CheckResult::Aggregation::last;
          check_result.outcome =
            check_result.value <= check_result.limit ? Outcome::passed : Outcome::warned;
          check_result.message =
            "the largest pressure differs by that fraction from the extrapolation of its neighbours: its "
            "error may be as large, and is unbounded at a sharp edge, where the pressure is singular";
          check_result.advice =
            "refine there (Mesh/Contact refinements, Refinement regions), round the edge, or use forces only";
          check_results.push_back(check_result);
        }
      return check_results;
    }

    /// Check that the tangent stiffness is positive definite (finite strain only; at small strain
    /// bodies do not buckle).
    CheckResult
    check_stability(const nlohmann::ordered_json &results)
    {
      CheckResult check_result;
      check_result.check = "tangent definiteness";
      check_result.value = results["tangent_positive_definite"] ? 0 : 1;
      check_result.limit = 0;
      check_result.outcome =
        results["tangent_positive_definite"] ? Outcome::passed : Outcome::warned;
      check_result.message =
        "the tangent stiffness is not positive definite: this equilibrium may be unstable (buckling)";
      check_result.advice =
        "use smaller load steps to find the critical load; beyond it no stable equilibrium exists under load control";
      return check_result;
    }

    /// Check for snap-through between two load steps.
    CheckResult
    check_jump(const nlohmann::ordered_json &results)
    {
      CheckResult check_result;
      check_result.check   = "snap-through ratio";
      check_result.value   = results["snap_through_ratio"];
      check_result.limit   = 3;
      check_result.outcome = check_result.value == 0 ? Outcome::passed : Outcome::warned;
      check_result.message =
        "in this load step the displacement rate is that many times the rate of the load step before, and "
        "the tangent stiffness is not positive definite half-way: the bodies have probably snapped through";
      check_result.advice =
        "use displacement control to follow the path; the dynamic jump itself is not modelled (quasi-static equations)";
      return check_result;
    }

    /// Check that the solution is not one of several by its friction.
    CheckResult
    check_uniqueness(const nlohmann::ordered_json &results)
    {
      return make_check_result(
        "friction / critical friction",
        "",
        results["friction_over_critical"],
        1,
        "friction at slipping points is that many times a critical one, beyond which the same loads have several "
        "solutions: which one the bodies take depends on what the quasi-static equations do not contain",
        "compare with more load steps, and with a smaller friction coefficient; a solution that jumps between them is "
        "one of several");
    }

    /// Check the rounding of coordinates: far from the origin gaps are small differences of large
    /// numbers.
    template <int dim>
    std::vector<CheckResult>
    check_coordinates(const Snapshot<dim> &now, const std::vector<Extremes> &extremes)
    {
      constexpr double far    = 100; // sizes of the scene; nearer, digits are not lost by that
      const auto &[low, high] = now.elasticity.mesh().extent().get_boundary_points();
      // The rounding of a coordinate is the machine precision times the distance from the origin; a
      // gap is a difference of a few of them. It is compared with the deformation, the strain times
      // the size of the model.
      const double offset = (low + (high - low) / 2).norm(), size = now.elasticity.mesh().size();
      double       strain = 0;
      for (const Extremes &of_body : extremes)
        strain = std::max(strain, of_body.gradient);
      if (offset < far * size || strain == 0)
        return {};
      CheckResult check_result;
      check_result.check   = "coordinate round-off";
      check_result.value   = 4 * std::numeric_limits<double>::epsilon() * offset / (strain * size);
      check_result.limit   = 1e-3;
      check_result.outcome = check_result.value <= check_result.limit ? Outcome::passed :
                             check_result.value <= 0.1                ? Outcome::warned :
                                                                        Outcome::failed;
      check_result.message =
        "the model lies so far from the origin that the round-off of coordinates, and thus of "
        "gaps, is that fraction of the deformation";
      check_result.advice =
        "shift the model to the origin: Corners or Center of bodies and obstacles, or for mesh files "
        "Transformation = x - ...; and formulas in x, y, z accordingly";
      return {check_result};
    }



    /// @return the area of a square of the size of the model; its length where forces are per
    /// thickness.
    template <int dim>
    double
    area_of_size(const Snapshot<dim> &s)
    {
      const bool is_plane = dim == 2 && s.elasticity.model() != Model::axisymmetric;
      return std::pow(s.elasticity.mesh().size(), is_plane ? 1 : 2);
    }

    /// Motions smaller than this share of the size of the model are rounding of positions.
    constexpr double least_motion = 1e-14; // of the size of the scene

    /// @return whether forces act on bodies or move them; forces that would strain the softest body
    /// by rounding only do not count.
    template <int dim>
    bool
    acts_on_bodies(const Snapshot<dim>         &s,
                   const std::vector<Extremes> &extremes,
                   const double                 largest_force)
    {
      // A force counts if it could strain the softest material by more than rounding over an area
      // of the size of the model.
      const double size                  = s.elasticity.mesh().size();
      double       minimal_penalty_scale = std::numeric_limits<double>::max();
      for (const Material &material : s.elasticity.all_materials())
        minimal_penalty_scale = std::min(minimal_penalty_scale, material.youngs_modulus);
      return largest_force > least_motion * minimal_penalty_scale * area_of_size(s) ||
             std::any_of(extremes.begin(), extremes.end(), [&](const Extremes &body) {
               return body.motion > least_motion * size;
             });
    }

    /// Check that there is any force or motion; otherwise loads were forgotten or not imported. A
    /// scene with expected results is assumed to be intended.
    template <int dim>
    CheckResult
    check_something_acts(const Scene<dim>    &scene,
                         const Snapshot<dim> &now,
                         const bool           acts_on_bodies)
    {
      const bool acts = acts_on_bodies || now.displacement.linfty_norm() >
                                            least_motion * now.elasticity.mesh().size();
      CheckResult check_result;
      check_result.check = "loading";
      check_result.value = acts;
      check_result.limit = 1;
      // Load steps may begin with nothing; one step with an action suffices.
      check_result.aggregation = CheckResult::Aggregation::best;
      check_result.outcome = acts || !scene.expected.empty() ? Outcome::passed : Outcome::failed;
      check_result.message =
        "no force acts and nothing moves: loads or prescribed displacements are missing";
      check_result.advice =
        "check Loads, Supports and Not imported; if this is intended, add Expected results";
      return check_result;
    }

    /// @return the force of the largest strain times Young's modulus on an area of the size of the
    /// model, a scale for rounding of forces.
    template <int dim>
    double
    elastic_force(const Snapshot<dim> &s, const std::vector<Extremes> &extremes)
    {
      // Internal stresses may be in balance without any external force, as in a heated body: then
      // their rounding is the scale of forces.
      double stress = 0;
      for (unsigned int id = 0; id < s.elasticity.all_materials().size(); ++id)
        stress = std::max(stress,
                          s.elasticity.material(id).youngs_modulus *
                            extremes[s.elasticity.mesh().body_of_material(id)].gradient);
      return stress * area_of_size(s);
    }
  } // namespace



  // Scales come first, then all checks in the order in which they are reported.
  template <int dim>
  std::vector<CheckResult>
  check_solution(const Decisions<dim>         &decisions,
                 const Snapshot<dim>          &now,
                 const nlohmann::ordered_json &results,
                 const double                  largest_force)
  {
    const Scene<dim> &scene    = decisions.scene;
    constexpr double  rounding = 1e-6; // of elastic forces that are in balance inside of bodies
    // With targets iterations end earlier, where their error is negligible.
    double small = 1e-5;
    if (scene.goals.has_targets())
      small =
        std::max(small,
                 0.05 * *std::min_element(scene.goals.targets.begin(), scene.goals.targets.end()));
    const auto   extremes        = extremes_of_bodies(now);
    const double scale           = std::max(largest_force, rounding * elastic_force(now, extremes));
    std::vector<CheckResult> all = check_motions(now, extremes);
    const bool               acts = acts_on_bodies(now, extremes, results["largest_force"]);
    all.push_back(check_something_acts(scene, now, acts));
    // The order is that of the report. All checks are evaluated on all ranks, also those that do
    // not communicate.
    for (const auto &some : {check_locking(now),
                             check_pairs(decisions, now, extremes, results, scale),
                             check_normal_forces(results, scale),
                             check_peaks(results, scale),
                             check_loads(scene, now),
                             check_fluids(results, scale),
                             check_equations(now),
                             check_coordinates(now, extremes),
                             check_skipped_items(scene, acts),
                             check_balance(results, scale, small)})
      all.insert(all.end(), some.begin(), some.end());
    if (now.elasticity.is_finite_strain())
      {
        all.push_back(check_stability(results));
        all.push_back(check_jump(results));
      }
    if (scene.contact.chosen().has_friction)
      all.push_back(check_uniqueness(results));
    all.push_back(check_undetected_penetration(scene, now));
    return all;
  }



  template std::vector<CheckResult>
  check_solution(const Decisions<2> &, const Snapshot<2> &, const nlohmann::ordered_json &, double);
  template std::vector<CheckResult>
  check_solution(const Decisions<3> &, const Snapshot<3> &, const nlohmann::ordered_json &, double);
} // namespace Signorini
