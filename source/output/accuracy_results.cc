// SPDX-License-Identifier: Apache-2.0
#include "output/accuracy_results.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>

namespace Signorini
{
  namespace
  {
    /// @return null where there is no bound: JSON has no infinity.
    Json
    bound_or_null(const double bound)
    {
      return std::isfinite(bound) ? Json(bound) : Json();
    }
  } // namespace



  // One entry for each quantity; errors are in the units of the quantity.
  Json
  accuracy_results(const Goals &goals, const ErrorControl &control, const ErrorEstimate &estimate)
  {
    Json quantities = Json::object();
    for (unsigned int i = 0; i < goals.quantities.size(); ++i)
      {
        const ErrorHistory     &history = control.quantities()[i];
        const QuantityEstimate &last    = history.last();
        const BoundedValue      now     = history.last_bounded();
        Json                   &one     = quantities[goals.quantities[i]];
        one["value"]                    = now.value;
        one["error_bound"]              = bound_or_null(now.error_bound);
        one["stable"]                   = !last.is_unstable;
        one["singular"]                 = last.is_singular;
        if (now.value != 0 && std::isfinite(now.error_bound))
          one["relative_error_bound"] = now.error_bound / std::abs(now.value);
        if (goals.has_targets())
          {
            one["target"] = goals.targets[i];
            one["met"]    = now.error_bound <= goals.targets[i] * control.scale(i);
          }
        if (const auto better = history.extrapolated())
          one["extrapolated"] = {{"value", better->value}, {"error_bound", better->error_bound}};
        // The contributions to the error bound in the units of the quantity, then auxiliary bounds
        // of the estimate.
        one["parts"]                = {{"discretisation", last.parts.discretisation},
                                       {"geometry", last.parts.geometry},
                                       {"enforcement", last.parts.enforcement},
                                       {"model", last.parts.model},
                                       {"path", last.parts.path},
                                       {"nonlinear", last.parts.nonlinear},
                                       {"algebraic", last.parts.algebraic}};
        one["absolute"]             = last.absolute;
        one["cauchy_schwarz_bound"] = last.cauchy_schwarz_bound;
        one["unresolved"]           = last.unresolved;
        one["regularised"]          = last.is_regularised;
      }
    return {{"energy", estimate.energy},
            {"quantities", quantities},
            {"dual_iterations", estimate.iterations}};
  }



  // The inverse of accuracy_results(), as far as error bounds need it.
  std::vector<QuantityEstimate>
  quantities_of(const Json &results)
  {
    std::vector<QuantityEstimate> all;
    for (const Json &one : results.at("quantities"))
      {
        QuantityEstimate read;
        const Json      &parts    = one.at("parts");
        read.value                = one.at("value");
        read.parts.discretisation = parts.at("discretisation");
        read.parts.geometry       = parts.at("geometry");
        read.parts.enforcement    = parts.at("enforcement");
        read.parts.model          = parts.at("model");
        read.parts.path           = parts.value("path", 0.);
        read.parts.nonlinear      = parts.at("nonlinear");
        read.parts.algebraic      = parts.at("algebraic");
        read.absolute             = one.at("absolute");
        read.cauchy_schwarz_bound = one.at("cauchy_schwarz_bound");
        read.unresolved           = one.at("unresolved");
        read.is_regularised       = one.at("regularised");
        read.is_unstable          = !one.value("stable", true);
        read.is_singular          = one.value("singular", false);
        all.push_back(read);
      }
    return all;
  }



  // Errors are relative unless the value is zero.
  void
  print_accuracy(const Goals &goals, const ErrorControl &control, std::ostream &out)
  {
    std::size_t widest = 8;
    for (const std::string &name : goals.quantities)
      widest = std::max(widest, name.size());
    const bool has_path =
      std::any_of(control.quantities().begin(),
                  control.quantities().end(),
                  [](const auto &history) { return history.last().parts.path != 0; });
    std::ostringstream text;
    text << "  " << std::left << std::setw(widest) << "error of" << std::right
         << "          value    bound     mesh geometry  penalty    model   solver"
         << (has_path ? "     path\n" : "\n");
    for (unsigned int i = 0; i < goals.quantities.size(); ++i)
      {
        const ErrorHistory &history = control.quantities()[i];
        const ErrorParts   &parts   = history.last().parts;
        const BoundedValue  now     = history.last_bounded();
        const double        unit    = now.value != 0 ? std::abs(now.value) : 1;
        text << "  " << std::left << std::setw(widest) << goals.quantities[i] << std::right
             << std::setprecision(7) << std::setw(15) << now.value << std::setprecision(1)
             << std::scientific << std::setw(9) << now.error_bound / unit << std::setw(9)
             << parts.discretisation / unit << std::setw(9) << parts.geometry / unit << std::setw(9)
             << parts.enforcement / unit << std::setw(9) << parts.model / unit << std::setw(9)
             << (parts.algebraic + parts.nonlinear) / unit;
        if (has_path)
          text << std::setw(9) << parts.path / unit;
        text << std::defaultfloat << "\n";
      }
    out << text.str();
  }
} // namespace Signorini
