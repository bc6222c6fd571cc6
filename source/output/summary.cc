// SPDX-License-Identifier: Apache-2.0
#include "output/summary.h"

#include <nlohmann/json.hpp>

#include <iomanip>
#include <ostream>
#include <sstream>

namespace Signorini
{
  using Json = nlohmann::ordered_json;

  namespace
  {
    /// @return an array as text.
    std::string
    numbers(const Json &list)
    {
      std::ostringstream text;
      text << std::setprecision(6) << "(";
      for (unsigned int i = 0; i < list.size(); ++i)
        text << (i > 0 ? ", " : "") << list[i].get<double>();
      return text.str() + ")";
    }

    /// @return the three violations of the contact conditions as text.
    std::string
    violations(const Json &conditions)
    {
      std::ostringstream text;
      text << std::scientific << std::setprecision(2);
      for (const char *name : {"max_penetration", "max_tension", "complementarity"})
        text << std::setw(11) << conditions[name].get<double>();
      return text.str();
    }
  } // namespace



  // The last load step; units are those of the scene.
  void
  print_summary(const Json &results, std::ostream &out)
  {
    const Json &step = results["load_steps"].back();
    out << std::setprecision(6);
    // Contact pairs: resultants, the largest pressure, and the largest violations of the contact
    // conditions.
    for (const auto &[name, pair] : step["pairs"].items())
      out << "\n  pair " << name << ":  force on " << pair["slave"].get<std::string>() << " "
          << numbers(pair["force"]) << ", pressure times area "
          << pair["normal_force"].get<double>() << ", area " << pair["area"].get<double>()
          << "\n    largest pressure " << pair["max_pressure"].get<double>()
          << (pair["separates"].get<bool>() ? "\n    largest violations: penetration, tension, " :
                                              "\n    no separation: largest distance, tension, ")
          << "|pressure x gap|\n      at the sampling points      " << violations(pair)
          << "\n      at the contact points       " << violations(pair["at_points"]) << "\n";
    // Reactions, the motions of obstacles, and modes that the contact has not constrained.
    for (const auto &[name, support] : step["supports"].items())
      out << "  support " << name << ":  force " << numbers(support["reaction"]) << "\n";
    for (const auto &[name, obstacle] : step["obstacles"].items())
      out << "  obstacle " << name << ":  moved by " << numbers(obstacle["displacement"])
          << ", rotated by " << numbers(obstacle["rotation"]) << ", force "
          << numbers(obstacle["force"]) << ", moment " << numbers(obstacle["moment"]) << "\n";
    for (const auto &[name, fluid] : step["fluids"].items())
      out << "  fluid " << name << ":  acts on an area of " << fluid["wet_area"].get<double>()
          << " of " << fluid["area"].get<double>() << "\n";
    for (const auto &[name, section] : step["cross_sections"].items())
      {
        out << "  cross section " << name << ":  force " << numbers(section["force"]) << ", moment "
            << numbers(section["moment"]) << "\n";
        if (const double size = section["uncertainty"]; size > 0)
          out << "    known up to a force of " << size
              << ", which loads and contact exert on the cells that are cut\n";
      }
    if (step.contains("stabilised_modes"))
      for (const auto &name : step["stabilised_modes"]["names"])
        out << "  unconstrained mode: " << name.get<std::string>()
            << ", stabilised by a force of at most "
            << step["stabilised_modes"]["largest_force"].get<double>() << "\n";
    out << "  sum of all forces / largest: " << step["force_balance"].get<double>()
        << ", of moments / (largest force times size): " << step["moment_balance"].get<double>()
        << "\n";

    // Deviations from a known solution, if the scene has one.
    if (step.contains("errors"))
      {
        out << "  relative errors:";
        for (const auto &[name, error] : step["errors"].items())
          out << "  " << name << " " << error.get<double>();
        out << "\n";
      }

    // Costs of the whole run.
    out << "\n  seconds:";
    for (const auto &[name, time] : results["seconds"].items())
      out << "  " << name << " " << std::fixed << std::setprecision(2) << time.get<double>();
    if (results.contains("linear_reference"))
      {
        const Json &linear = results["linear_reference"];
        out << "\n  compared with the linear solve without contact: " << std::setprecision(2)
            << linear["time_ratio"].get<double>() << " times the seconds, "
            << linear["cycle_ratio"].get<double>() << " times the multigrid cycles";
      }
    out << std::defaultfloat << std::setprecision(6) << "\n  peak memory per rank: ";
    for (const Json &mb : results["peak_memory_mb"])
      out << mb.get<double>() << " ";
    out << "MB\n";
  }
} // namespace Signorini
