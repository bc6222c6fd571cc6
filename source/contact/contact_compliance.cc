// SPDX-License-Identifier: Apache-2.0
#include <signorini/contact/contact_compliance.h>
#include <signorini/parameters/section.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The exponential relation falls to this share of its pressure at zero gap over its clearance.
    constexpr double least_share = 0.01;

    /// The first point of the table whose value f is at least x, but not the first of all, so that
    /// it ends a segment. Beyond the table the last segment continues.
    template <typename F>
    std::vector<Point<2>>::const_iterator
    segment_end(const std::vector<Point<2>> &table, const double x, const F &f)
    {
      auto end = table.begin() + 1;
      while (end + 1 != table.end() && f(*end) < x)
        ++end;
      return end;
    }
  } // namespace



  void
  ContactCompliance::declare(Section &section)
  {
    section.add_choice(
      "Pressure-overclosure",
      kind,
      {{"hard", PressureOverclosure::hard},
       {"linear", PressureOverclosure::linear},
       {"exponential", PressureOverclosure::exponential},
       {"tabular", PressureOverclosure::tabular}},
      "hard: no penetration; linear: an elastic layer with the Normal stiffness; "
      "exponential: pressure p0 100^(d/c0) with overclosure d, Pressure at zero gap "
      "p0 and Clearance c0; tabular: by the Overclosure table");
    section.add("Normal stiffness",
                normal_stiffness,
                "pressure per overclosure of Pressure-overclosure = linear [force/length^3]",
                positive);
    section.add(
      "Tangential stiffness",
      tangential_stiffness,
      "tangential traction per slip where tied surfaces, or surfaces with friction, stick "
      "[force/length^3]",
      positive);
    section.add("Clearance",
                clearance,
                "gap below which there is pressure, of Pressure-overclosure = exponential [length]",
                non_negative);
    section.add("Pressure at zero gap",
                pressure_at_zero_gap,
                "pressure where surfaces touch, of Pressure-overclosure = exponential [force/area]",
                non_negative);
    section.add("Overclosure table",
                table,
                "of Pressure-overclosure = tabular: pressure, overclosure; the next two; ... "
                "Pressures increase from 0, negative overclosures are gaps, and the last line "
                "continues [force/area, length]");
  }



  // Values that belong to another relation are refused, so that none is without effect. Defaults
  // are not: scenes that the program writes contain all keys.
  void
  ContactCompliance::check_keys(Section   &section,
                                const bool is_bonded,
                                const bool has_slip_law) const
  {
    using Kind       = PressureOverclosure;
    const auto check = [&](const std::string &key, const bool is_given, const Kind of) {
      if (is_given && kind != of)
        section.fail(key, "does not apply to this Pressure-overclosure; remove it, or change that");
      if (!is_given && kind == of)
        section.fail("Pressure-overclosure", "requires " + key + "; set it");
    };
    check("Normal stiffness", std::isfinite(normal_stiffness), Kind::linear);
    check("Clearance", clearance > 0, Kind::exponential);
    check("Pressure at zero gap", pressure_at_zero_gap > 0, Kind::exponential);
    check("Overclosure table", !table.empty(), Kind::tabular);
    if (is_bonded && is_nonlinear())
      section.fail("Pressure-overclosure",
                   "is no relation for tension, which tied surfaces and those without separation "
                   "carry; use linear or hard");
    if (!has_slip_law && std::isfinite(tangential_stiffness))
      section.fail("Tangential stiffness",
                   "has no effect without Friction or Law = tied; remove it, or add these");
    if (kind != Kind::tabular)
      return;
    if (table.size() < 2 || table[0][0] != 0)
      section.fail("Overclosure table",
                   "requires two lines at least, of which the first has no pressure");
    for (unsigned int i = 1; i < table.size(); ++i)
      if (!(table[i][0] > table[i - 1][0] && table[i][1] > table[i - 1][1]))
        section.fail("Overclosure table",
                     "pressures and overclosures must increase from line to line");
  }



  ContactCompliance::Value
  ContactCompliance::overclosure(const double pressure) const
  {
    if (kind == PressureOverclosure::linear)
      return {pressure / normal_stiffness, 1 / normal_stiffness};
    if (kind == PressureOverclosure::exponential)
      {
        if (pressure <= least_share * pressure_at_zero_gap)
          return {-clearance, 0.};
        const double length = clearance / std::log(1 / least_share);
        return {length * std::log(pressure / pressure_at_zero_gap), length / pressure};
      }
    if (kind == PressureOverclosure::tabular)
      {
        const auto end = segment_end(table, pressure, [](const Point<2> &line) { return line[0]; });
        const Point<2> &from  = *(end - 1);
        const double    slope = ((*end)[1] - from[1]) / ((*end)[0] - from[0]);
        return {from[1] + slope * (pressure - from[0]), slope};
      }
    return {0., 0.};
  }



  // With the segments of overclosure(), so that both are inverse to each other to rounding.
  double
  ContactCompliance::pressure(const double overclosure) const
  {
    if (kind == PressureOverclosure::linear)
      return normal_stiffness * overclosure;
    if (kind == PressureOverclosure::exponential)
      return overclosure <= -clearance ?
               0. :
               pressure_at_zero_gap * std::pow(least_share, -overclosure / clearance);
    if (overclosure <= table[0][1])
      return 0;
    const auto end = segment_end(table, overclosure, [](const Point<2> &line) { return line[1]; });
    const Point<2> &from = *(end - 1);
    return from[0] + ((*end)[0] - from[0]) * (overclosure - from[1]) / ((*end)[1] - from[1]);
  }



  double
  ContactCompliance::reach() const
  {
    return std::max(0., -overclosure(0).value);
  }



  ContactCompliance::Value
  ContactCompliance::pressure(const double trial, const double epsilon) const
  {
    double p = trial;
    if (kind == PressureOverclosure::linear)
      p = trial / (1 + epsilon / normal_stiffness);
    else if (kind == PressureOverclosure::tabular)
      {
        const double first = table[0][1];
        const auto   value = [&](const Point<2> &line) {
          return line[0] + epsilon * (line[1] - first);
        };
        const auto     end   = segment_end(table, trial, value);
        const Point<2> from  = *(end - 1);
        const double   share = (trial - value(from)) / (value(*end) - value(from));
        p                    = from[0] + share * ((*end)[0] - from[0]);
      }
    else if (kind == PressureOverclosure::exponential && trial > least_share * pressure_at_zero_gap)
      {
        // Newton's method for q = log(p/p0): the function is convex and increases, and the start is
        // where it is not negative, so that iterates decrease to the solution.
        const double a = epsilon * clearance / std::log(1 / least_share),
                     b = epsilon * clearance - trial;
        double q       = std::log(trial / pressure_at_zero_gap);
        for (unsigned int i = 0; i < 100; ++i)
          {
            p                   = pressure_at_zero_gap * std::exp(q);
            const double change = (p + a * q + b) / (p + a);
            q -= change;
            if (std::abs(change) < 1e-14 * std::max(1., std::abs(q)))
              break;
          }
        p = pressure_at_zero_gap * std::exp(q);
      }
    return {p, 1 / (1 + epsilon * overclosure(p).derivative)};
  }
} // namespace Signorini
