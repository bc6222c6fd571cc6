// SPDX-License-Identifier: Apache-2.0
#include "output/preflight.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>

namespace Signorini
{
  using Json = nlohmann::ordered_json;

  namespace
  {
    /// @return a corner of a body as text, with enough digits for gaps of 1e-6 of its size, and
    /// without rounding errors.
    std::string
    text(const Json &numbers, const double size)
    {
      std::ostringstream out;
      out << std::setprecision(8) << "(";
      for (unsigned int i = 0; i < numbers.size(); ++i)
        {
          const double x = numbers[i];
          out << (i > 0 ? ", " : "") << (std::abs(x) < 1e-12 * size ? 0. : x);
        }
      return out.str() + ")";
    }

    /// @return the longest side of the bounding box of a body.
    double
    size_of(const Json &body)
    {
      double size = 0;
      for (unsigned int d = 0; d < body["from"].size(); ++d)
        size = std::max(size, body["to"][d].get<double>() - body["from"][d].get<double>());
      return size;
    }

    /// Print one line about a boundary.
    void
    print_boundary(const std::string &name,
                   const Json        &boundary,
                   const double       body_size,
                   std::ostream      &out)
    {
      const char *size = boundary.contains("area") ? "area" : "length";
      out << "    " << name << ": " << boundary["faces"].get<double>() << " faces, " << size << " "
          << boundary[size].get<double>() << ", center " << text(boundary["center"], body_size)
          << ", " << text(boundary["from"], body_size) << " to " << text(boundary["to"], body_size)
          << "\n";
    }

    /// @return a text about thermal expansion; the temperatures are those at the end.
    std::string
    heat_message(const Json &thermal)
    {
      std::ostringstream out;
      out << std::setprecision(4) << ", alpha";
      for (const auto &alpha : thermal["expansion"])
        out << " " << alpha.get<double>();
      out << ", temperature " << thermal["reference"].get<double>() << " -> "
          << thermal["from"].get<double>();
      if (thermal["to"] > thermal["from"])
        out << " ... " << thermal["to"].get<double>();
      return out.str();
    }

    /// Print some lines about a contact pair.
    void
    print_pair(const std::string &name, const Json &pair, std::ostream &out)
    {
      out << "  pair " << name << ": " << pair["slave"].get<std::string>() << " ("
          << pair["slave_faces"].get<double>() << " faces of size "
          << pair["slave_face_size"].get<double>() << ") on " << pair["master"].get<std::string>();
      if (pair.contains("master_faces"))
        out << " (" << pair["master_faces"].get<double>() << " of "
            << pair["master_face_size"].get<double>()
            << (pair["matching"].get<bool>() ? ", matching)" : ")");
      out << (pair["separates"].get<bool>() ? "\n" : ", never to separate\n");
      if (!pair.contains("gap"))
        return;
      const Json &gap = pair["gap"];
      out << "    candidates: " << pair["candidates"] << " points on "
          << std::lround(100 * pair["covered_share"].get<double>()) << " % of the slave, gaps from "
          << gap["least"].get<double>() << " to " << gap["largest"].get<double>() << "; "
          << std::lround(100 * gap["overlapping"].get<double>()) << " % overlap, "
          << std::lround(100 * gap["touching"].get<double>()) << " % touch, "
          << std::lround(100 * gap["open"].get<double>()) << " % are open\n";
    }
  } // namespace



  void
  print_preflight(const Json &report, std::ostream &out, const bool with_boundaries)
  {
    out << std::setprecision(4);
    for (const auto &[name, body] : report["bodies"].items())
      {
        const double size = size_of(body);
        out << "  body " << name << ": " << text(body["from"], size) << " to "
            << text(body["to"], size) << ", " << body["cells"] << " cells of degree "
            << body["degree"] << ", E " << body["youngs_modulus"].get<double>() << ", nu "
            << body["poissons_ratio"].get<double>()
            << (body["formulation"] == "mixed" ? ", mixed" : "")
            << (body["law"] == "linear" ? "" : ", " + body["law"].get<std::string>())
            << (body.contains("thermal") ? heat_message(body["thermal"]) : "") << "\n";
        if (with_boundaries)
          for (const auto &[boundary, facts] : body["boundaries"].items())
            print_boundary(name + "." + boundary, facts, size, out);
      }
    for (const auto &[name, pair] : report["pairs"].items())
      print_pair(name, pair, out);
    for (const auto &motion : report["modes_constrained_by_contact"])
      out << "  constrained by contact alone: " << motion.get<std::string>() << "\n";
    if (report["operator"] != "assembled")
      out << "  stiffness operator: " << report["operator"].get<std::string>() << "\n";
    for (const auto &what : report["skipped"])
      out << "  skipped: " << what.get<std::string>() << "\n";
    for (const auto &warning : report["warnings"])
      out << "  WARNING: " << warning.get<std::string>() << "\n";
    const double seconds = report["predicted"]["seconds"],
                 memory  = report["predicted"]["memory_mb"];
    if (!std::isfinite(seconds))
      {
        out
          << "  expected: "
          << (std::isfinite(memory) ?
                "the time of finite-strain solutions cannot be predicted; " :
                "time and memory of a direct solver cannot be predicted; in 3D the time grows with "
                "the square of the number of unknowns");
        if (std::isfinite(memory))
          out << std::setprecision(3) << memory << " MB a rank";
        out << "\n" << std::flush;
        return;
      }
    out << "  expected: " << std::setprecision(2);
    if (seconds < 1)
      out << "less than a second";
    else
      out << "about " << seconds << " s";
    out << " and " << std::setprecision(3) << memory << " MB a rank\n" << std::flush;
  }
} // namespace Signorini
