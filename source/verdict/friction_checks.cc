// SPDX-License-Identifier: Apache-2.0
#include "verdict/pair_checks.h"

#include <algorithm>
#include <cmath>

namespace Signorini
{
  namespace
  {
    /// Check that tangential tractions are inside of the cone, relative to the largest one.
    CheckResult
    check_cone(const std::string &name, const nlohmann::ordered_json &results, const double area)
    {
      // Where mu vanishes tractions are rounding.
      constexpr double rounding = 1e-8;
      const double     normal   = results["normal_force"],
                   largest      = std::max(results["max_tangential_traction"].get<double>(),
                                      area > 0 ? rounding * normal / area : 0.),
                   excess       = results["max_friction_excess"];
      CheckResult result        = make_check_result(
        "tangential traction beyond friction",
        name,
        largest > 0 ? excess / largest : 0.,
        1e-6,
        "tangential tractions exceed the friction coefficient times the pressure, relative to "
               "the largest one",
        "set a smaller Newton/Tolerance");
      if (result.value > 1e-3)
        result.outcome = Outcome::failed;
      return result;
    }

    /// Check that friction takes work from the bodies, apart from rounding.
    /// @param face_size mean size of the faces of the slave [length]
    CheckResult
    check_dissipation(const std::string            &name,
                      const nlohmann::ordered_json &results,
                      const double                  area,
                      const double                  face_size)
    {
      const double work  = results["total_friction_work"],
                   scale = results["max_tangential_traction"].get<double>() *
                           results["max_slip_since_contact"].get<double>() * area,
                   rounding    = 1e-10 * results["normal_force"].get<double>() * face_size;
      CheckResult check_result = make_check_result(
        "work of friction",
        name,
        -work > rounding ? -work / scale : 0.,
        1e-6,
        "friction gives work to the bodies, which it cannot",
        "set a smaller Newton/Tolerance, and report this as an error of the program");
      if (check_result.outcome == Outcome::warned)
        check_result.outcome = Outcome::failed;
      return check_result;
    }

    /// Check that a contact area that grows under friction does not do so in one load step: its
    /// tractions depend on the path.
    CheckResult
    check_path(const std::string            &name,
               const nlohmann::ordered_json &results,
               const ContactExtent          &extent,
               const unsigned int            step)
    {
      constexpr double none    = 1e-9; // gaps and tractions relative to others
      const double     largest = results["max_tangential_traction"];
      const bool       grew    = extent.largest_reference_gap > none * std::sqrt(extent.active);
      CheckResult      check_result;
      check_result.check       = "load steps of the path";
      check_result.where       = "pair " + name;
      check_result.aggregation = CheckResult::Aggregation::last;
      check_result.value       = step;
      check_result.limit       = 2;
      check_result.outcome     = step < 2 && grew && largest > 1e-3 * extent.pressure &&
                                 results["slip_area"].get<double>() > 0 ?
                                   Outcome::warned :
                                   Outcome::passed;
      check_result.message =
        "the contact area grows under friction in a single load step: stick zone and tangential tractions may be wrong by tens of percent";
      check_result.advice = "set Load steps/Number = 10, and compare with 20";
      return check_result;
    }

    /// Check that the coefficient hardly changes by the slip of the load step, before which it is
    /// taken.
    CheckResult
    check_change_of_friction(const std::string &name, const nlohmann::ordered_json &results)
    {
      return make_check_result(
        "friction coefficient within a load step",
        name,
        results["friction_change"],
        0.05,
        "the slip of the load step changes the friction coefficient by that fraction, but the one before the slip acts",
        "take more load steps, or set Load steps/Number = automatic");
    }
  } // namespace



  std::vector<CheckResult>
  check_friction(const std::string            &name,
                 const nlohmann::ordered_json &results,
                 const ContactExtent          &extent,
                 const double                  face_size,
                 const unsigned int            step)
  {
    return {check_cone(name, results, extent.active),
            check_dissipation(name, results, extent.active, face_size),
            check_change_of_friction(name, results),
            check_path(name, results, extent, step)};
  }



  std::vector<CheckResult>
  check_path_error(const double error, const double limit)
  {
    return {make_check_result(
      "path error",
      "",
      error,
      limit,
      "halving the load steps changes tangential tractions, or the work of friction, by that fraction of the largest "
      "ones, in the sum of all load steps: results may be off by as much",
      "set a smaller Load steps/Path error, and more Cut-backs if load steps are as short as these allow")};
  }



  std::vector<CheckResult>
  check_deviation_of_loads(const double deviation)
  {
    return {make_check_result(
      "loads within a load step",
      "",
      deviation,
      0.1,
      "supports or loads leave the straight way of the load step by that fraction of their largest values, or return "
      "on it: with friction, what they do there counts, and is left out",
      "let load steps end where directions change (Load steps/Times), take more of them, or set Load steps/Number = automatic")};
  }
} // namespace Signorini
