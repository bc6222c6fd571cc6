// SPDX-License-Identifier: Apache-2.0
#include "accuracy/error_history.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
  // The observed reduction of the absolute cell sum, rho of (8.14); the upper limit if there is no
  // other mesh. It is small where the degree was raised.
  double
  ErrorHistory::reduction() const
  {
    constexpr double   least = 0.1, most = 0.85;
    const unsigned int n      = size();
    const double       before = n < 2 ? 0. : meshes[n - 2].absolute;
    return before > 0 ? std::clamp(meshes[n - 1].absolute / before, least, most) : most;
  }



  // The remaining change as a geometric series, Delta of (8.14).
  double
  ErrorHistory::by_changes() const
  {
    const unsigned int n = size();
    if (n < 2)
      return 0;
    const double factor = reduction();
    double       change = std::abs(meshes[n - 1].value - meshes[n - 2].value);
    // A single change may be small by chance, if the value oscillates about its limit.
    if (n > 2)
      change = std::max(change, factor * std::abs(meshes[n - 2].value - meshes[n - 3].value));
    return change * factor / (1 - factor);
  }



  // Equation (8.13) of doc/theory. With these factors about 19 of 20 bounds contain the exact value
  // (scripts/accuracy, which describes how they were fitted).
  BoundedValue
  ErrorHistory::last_bounded() const
  {
    constexpr double        rounding = 1e-9;
    const QuantityEstimate &now      = last();
    if (now.is_unstable || now.is_singular)
      return {now.value, std::numeric_limits<double>::infinity()};
    // Errors of penalty and mesh often have opposite signs and cancel; a soft penalty must not
    // profit from that.
    const double correction = now.parts.size_of_correction(),
                 stiffness  = 0.5 * std::abs(now.parts.enforcement);
    double error_bound;
    if (now.is_regularised && size() > 1)
      // The dual solution of a regularised quantity belongs to a similar one: it ranks cells well,
      // but the sum over them is less reliable than the changes from mesh to mesh.
      error_bound = std::max(0.6 * correction + 0.1 * now.absolute + stiffness, 1.2 * by_changes());
    else
      error_bound = std::max(1.3 * correction + 0.3 * now.absolute + stiffness, 0.5 * by_changes());
    // Errors of cells may cancel. On the first mesh, where no change of the value is known, the
    // Cauchy-Schwarz bound is taken into account.
    if (size() == 1)
      error_bound = std::max(error_bound, now.cauchy_schwarz_bound / 4);
    return {now.value,
            error_bound + now.unresolved + now.parts.of_model_and_path() +
              rounding * std::abs(now.value)};
  }



  ErrorHistory
  ErrorHistory::without_solver() const
  {
    ErrorHistory result                  = *this;
    result.meshes.back().parts.nonlinear = 0;
    result.meshes.back().parts.algebraic = 0;
    return result;
  }



  ErrorHistory
  ErrorHistory::without_enforcement() const
  {
    ErrorHistory result                    = *this;
    result.meshes.back().parts.enforcement = 0;
    return result;
  }



  // Equation (8.15) of doc/theory.
  std::optional<BoundedValue>
  ErrorHistory::extrapolated() const
  {
    const unsigned int n = size();
    if (n < 3 || last().is_regularised)
      return {};
    double corrected[3], correction[3];
    for (unsigned int k = 0; k < 3; ++k)
      {
        const QuantityEstimate &one = meshes[n - 3 + k];
        correction[k]               = one.parts.correction();
        corrected[k]                = one.value + correction[k];
      }
    // The corrections must have one sign, and each must be smaller than the one before.
    for (unsigned int k = 1; k < 3; ++k)
      if (correction[k] * correction[k - 1] <= 0 ||
          std::abs(correction[k]) > 0.85 * std::abs(correction[k - 1]))
        return {};
    const double error_bound =
      std::max(std::abs(corrected[2] - corrected[1]), std::abs(corrected[1] - corrected[0]) / 2);
    if (error_bound > 0.5 * last_bounded().error_bound)
      return {};
    return BoundedValue{corrected[2],
                        std::max(error_bound, 0.25 * std::abs(correction[2])) +
                          last().parts.of_model_and_path()};
  }



  bool
  ErrorHistory::is_zero() const
  {
    constexpr unsigned int enough = 4;
    constexpr double       small  = 0.1;
    return size() >= enough &&
           std::all_of(meshes.end() - enough, meshes.end(), [](const QuantityEstimate &one) {
             return std::abs(one.value) <=
                    small * (0.2 * one.absolute + one.parts.size_of_correction() + one.unresolved);
           });
  }



  bool
  ErrorHistory::diverges() const
  {
    // Errors of the order of the square root of the mesh size, the slowest that converge in
    // practice, let differences decrease by a factor of 0.7 with each refinement; singular values
    // without limit change by as much on each mesh, or more.
    constexpr unsigned int enough = 4;
    constexpr double       slow   = 0.9;
    const unsigned int     n      = size();
    if (n < enough + 1)
      return false;
    for (unsigned int k = n - enough + 1; k < n; ++k)
      {
        const double now    = meshes[k].value - meshes[k - 1].value,
                     before = meshes[k - 1].value - meshes[k - 2].value;
        if (now * before <= 0 || std::abs(now) < slow * std::abs(before))
          return false;
      }
    return std::abs(meshes[n - 1].value - meshes[n - 2].value) > 1e-3 * std::abs(last().value);
  }
} // namespace Signorini
