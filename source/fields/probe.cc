// SPDX-License-Identifier: Apache-2.0
#include <signorini/fields/probe.h>
#include <signorini/parameters/section.h>

#include <sstream>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  void
  Probe<dim>::declare(Section &section)
  {
    section.add("Body", body, "body that contains the point; empty: any");
    section.add(
      "Pair",
      pair,
      "contact pair instead of a body: pressure, gap and displacement at the slave surface "
      "point closest to Point");
    section.add("Point", point, "coordinates of the undeformed body, separated by commas [length]");
    section.add("End", end, "coordinates of the end of a line from Point; empty: a point alone");
    section.add("Points", n_points, "number of points on a line, including both ends", {2, 10000});
    if (!section.reading())
      return;
    if (!body.empty() && is_on_pair())
      section.fail("Pair", "is set together with Body = " + body + "; give one of them");
    if (is_line() && end.size() != dim)
      section.fail("End", "must have " + std::to_string(dim) + " coordinates, separated by commas");
    if (!is_line() && n_points != Probe().n_points)
      section.fail("Points", "is for lines; set End");
  }



  template <int dim>
  std::vector<Point<dim>>
  Probe<dim>::points() const
  {
    if (!is_line())
      return {point};
    std::vector<Point<dim>> result;
    for (unsigned int i = 0; i < n_points; ++i)
      {
        const double s = double(i) / (n_points - 1);
        result.emplace_back();
        for (unsigned int d = 0; d < dim; ++d)
          result.back()[d] = (1 - s) * point[d] + s * end[d];
      }
    return result;
  }



  template <int dim>
  std::vector<Probe<dim>>
  Probe<dim>::single() const
  {
    std::vector<Probe> result;
    for (const Point<dim> &x : points())
      {
        result.push_back(*this);
        result.back().point = x;
        result.back().end.clear();
      }
    return result;
  }



  template <int dim>
  std::string
  Probe<dim>::title() const
  {
    return "probe '" + name + "': ";
  }



  template <int dim>
  const Probe<dim> &
  probe_named(const Probes<dim> &probes, const std::string &name)
  {
    unsigned int i = 0;
    while (probes[i].name != name)
      ++i;
    return probes[i];
  }



  template <int dim>
  std::string
  point_text(const Point<dim> &x)
  {
    std::ostringstream text;
    text.precision(8);
    for (unsigned int d = 0; d < dim; ++d)
      text << (d == 0 ? "(" : ", ") << x[d];
    return text.str() + ")";
  }



  template const Probe<2> &
  probe_named(const Probes<2> &, const std::string &);
  template const Probe<3> &
  probe_named(const Probes<3> &, const std::string &);
  template std::string
  point_text(const Point<2> &);
  template std::string
  point_text(const Point<3> &);
  template struct Probe<2>;
  template struct Probe<3>;
} // namespace Signorini
