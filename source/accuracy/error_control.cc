// SPDX-License-Identifier: Apache-2.0
#include "accuracy/error_control.h"

#include <signorini/base/text.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  ErrorControl::ErrorControl(const Goals               &goals,
                             const RefinementSettings  &settings,
                             const std::vector<double> &least)
    : goals(goals)
    , settings(settings)
    , least(least)
    , histories(goals.quantities.size())
  {}



  void
  ErrorControl::add(const std::vector<QuantityEstimate> &on_next_mesh)
  {
    for (unsigned int i = 0; i < histories.size(); ++i)
      histories[i].add(on_next_mesh[i]);
  }



  void
  ErrorControl::replace_last(const std::vector<QuantityEstimate> &on_last_mesh)
  {
    for (unsigned int i = 0; i < histories.size(); ++i)
      histories[i].replace_last(on_last_mesh[i]);
  }



  void
  ErrorControl::follow_path(const std::vector<QuantityEstimate> &on_last_mesh)
  {
    for (unsigned int i = 0; i < histories.size(); ++i)
      histories[i].follow_path(on_last_mesh[i]);
  }



  void
  ErrorControl::set_path(const std::vector<double> &sizes)
  {
    for (unsigned int i = 0; i < sizes.size(); ++i)
      histories[i].set_path(sizes[i]);
  }



  bool
  ErrorControl::is_resolved() const
  {
    for (unsigned int i = 0; i < histories.size(); ++i)
      if (histories[i].size() == 0 ||
          histories[i].last_bounded().error_bound - histories[i].last().parts.of_model_and_path() >
            allowed(i))
        return false;
    return goals.has_targets();
  }



  double
  ErrorControl::scale(const unsigned int i) const
  {
    return std::max(std::abs(histories[i].last().value), least.empty() ? 0. : least[i]);
  }



  double
  ErrorControl::allowed(const unsigned int i) const
  {
    return goals.has_targets() ? goals.targets[i] * scale(i) : 0.;
  }



  // 2 % are reserved for the change of the bound by the last, more accurate solution.
  double
  ErrorControl::target_error(const unsigned int i) const
  {
    return 0.98 * allowed(i);
  }



  bool
  ErrorControl::is_met(const bool without_solver) const
  {
    for (unsigned int i = 0; i < histories.size(); ++i)
      {
        ErrorHistory history = histories[i];
        if (without_solver)
          history = history.without_solver();
        if (history.last_bounded().error_bound > (without_solver ? target_error(i) : allowed(i)))
          return false;
      }
    return goals.has_targets();
  }



  // Divergence, or a model error that is nearly as large as the target.
  std::string
  ErrorControl::obstacle(const bool path_is_final) const
  {
    for (unsigned int i = 0; i < histories.size(); ++i)
      {
        if (histories[i].last_bounded().error_bound <= allowed(i))
          continue;
        const std::string &name = goals.quantities[i];
        if (histories[i].last().is_unstable)
          return name +
                 " has no error bound: the tangent at the solution is not positive definite, so that "
                 "other solutions are near (a buckling or limit point was passed); set Load steps/End "
                 "time to a smaller load";
        if (histories[i].last().is_singular)
          return name +
                 " has no error bound: stresses have no limit there, at the end of a support or at "
                 "a re-entrant corner; choose the stress at a point farther away, or round the "
                 "corner";
        if (histories[i].is_zero())
          return name +
                 " is zero, as far as its error bounds tell, and no bound can be small relative to "
                 "it; choose another Accuracy/Quantity, or another component";
        if (histories[i].diverges())
          return name +
                 " grows with every refinement: the exact value is unbounded (sharp edge, point "
                 "force), or the initial mesh is too coarse (Mesh/Contact refinements); choose a "
                 "force, or a value farther away, as Accuracy/Quantity";
        if (const double model = histories[i].last().parts.model; model > 0.9 * allowed(i))
          return name + " is wrong by " +
                 short_text(100 * model / std::abs(histories[i].last().value)) +
                 " %, because contact is evaluated in the reference configuration; set Contact "
                 "method/Contact geometry = updated";
        if (!path_is_final)
          continue;
        const double path = histories[i].last().parts.path;
        if (path > 0.9 * allowed(i))
          return name + " changes by " +
                 short_text(100 * path / std::abs(histories[i].last().value)) +
                 " % with the length of the load steps, since friction depends on the path; set Load "
                 "steps/Number (or Times) to more load steps, or raise Accuracy/Time limit";
      }
    return {};
  }



  // What the errors of model and path, which no mesh reduces, leave of the target; a fifth of the
  // target at least.
  double
  ErrorControl::allowed_of_mesh(const unsigned int i) const
  {
    return std::max(0.2 * allowed(i), allowed(i) - histories[i].last().parts.of_model_and_path());
  }



  bool
  ErrorControl::needs_mesh() const
  {
    for (unsigned int i = 0; i < histories.size(); ++i)
      {
        ErrorHistory history = histories[i].without_solver().without_enforcement();
        if (history.last_bounded().error_bound > target_error(i))
          return true;
      }
    return !goals.has_targets();
  }



  // Equation (8.16) of doc/theory. Every quantity that has not reached its target adds its cell
  // errors in units of the target.
  std::vector<double>
  ErrorControl::indicators(const CellErrors &cells, const MPI_Comm comm) const
  {
    const auto sum_of = [&](const std::vector<double> &values) {
      double sum = 0;
      for (const double value : values)
        sum += std::abs(value);
      return Utilities::MPI::sum(sum, comm);
    };
    std::vector<double> result(cells.energy.size(), 0.);
    const auto          add = [&](const std::vector<double> &values, const double weight) {
      for (unsigned int cell = 0; cell < values.size(); ++cell)
        result[cell] += weight * std::abs(values[cell]);
    };
    if (histories.empty())
      add(cells.energy, 1.);
    for (unsigned int i = 0; i < histories.size(); ++i)
      {
        const BoundedValue error_bound = histories[i].last_bounded();
        if (goals.has_targets() && error_bound.error_bound <= target_error(i))
          continue;
        const double sum = sum_of(cells.products[i]), energy = sum_of(cells.energy);
        if (sum <= 0)
          {
            // No cell has the error of a probe among prescribed nodes: all cells count alike.
            if (histories[i].last().unresolved > 0)
              add(std::vector<double>(result.size(), 1.), 1.);
            continue;
          }
        const double unit =
          goals.has_targets() ? std::max(allowed(i), 1e-3 * sum) : std::abs(error_bound.value);
        const double weight = unit > 0 ? 1 / unit : 1 / sum;
        // The derivative of a regularised quantity determines only a part of its error: half of the
        // weight is given to the energy of the error.
        const double of_energy = histories[i].last().is_regularised ? 0.5 : 0.;
        add(cells.products[i], (1 - of_energy) * weight);
        if (energy > 0)
          add(cells.energy, of_energy * weight * sum / energy);
      }
    return result;
  }



  namespace
  {
    /// The share of the error that a refined cell retains: a quarter for degree one, less for
    /// others.
    constexpr double left = 0.25;
  } // namespace



  double
  ErrorControl::expected_reduction() const
  {
    return needs_mesh() ? 1 - (1 - left) * share() : 1;
  }



  double
  ErrorControl::excess_error() const
  {
    double result = 0;
    for (unsigned int i = 0; i < histories.size(); ++i)
      {
        const double error_bound =
          histories[i].last_bounded().error_bound - histories[i].last().parts.of_model_and_path();
        result = std::max(result, error_bound / allowed_of_mesh(i));
      }
    return result;
  }



  // Equation (8.17) of doc/theory.
  double
  ErrorControl::share() const
  {
    constexpr double least = 0.1, most = 0.75, reserve = 0.8;
    return std::clamp((1 - reserve / excess_error()) / (1 - left), least, most);
  }



  double
  ErrorControl::stiffening() const
  {
    // The tolerable share of the target, or of the mesh part while that is larger.
    constexpr double tolerable = 0.1, most = 1e3;
    double           result = 1;
    for (unsigned int i = 0; i < histories.size(); ++i)
      {
        const ErrorParts &parts = histories[i].last().parts;
        const double      limit = tolerable * std::max(allowed(i), std::abs(parts.discretisation));
        if (goals.has_targets() && std::abs(parts.enforcement) > 3 * limit)
          result = std::max(result, std::abs(parts.enforcement) / limit);
      }
    return std::min(result, most);
  }



  // The algebraic error is taken to be proportional to the tolerance of Newton's method.
  double
  ErrorControl::tolerance(const double present) const
  {
    constexpr double tolerable = 0.03, least = 1e-12;
    const double     most   = std::max(present, 10 * settings.tolerance);
    double           factor = std::numeric_limits<double>::max();
    for (unsigned int i = 0; i < histories.size(); ++i)
      {
        const QuantityEstimate &now = histories[i].last();
        // The next mesh is assumed to have at most half of the error.
        const double mesh =
          std::max(std::abs(now.parts.discretisation + now.parts.geometry), 0.1 * now.absolute);
        const double limit = tolerable * std::max(mesh, 0.1 * allowed(i)) / 2;
        if (now.parts.algebraic != 0)
          factor = std::min(factor, limit / std::abs(now.parts.algebraic));
      }
    return std::clamp(present * std::clamp(factor, 1e-3, 10.), least, most);
  }
} // namespace Signorini
