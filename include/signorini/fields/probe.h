// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/point.h>

#include <string>
#include <vector>

namespace Signorini
{
  class Section;

  /// A named point, or points along a straight line, in a body or on the slave of a pair, in the
  /// reference configuration.
  template <int dim>
  struct Probe
  {
    std::string name;
    /// Name of the body; empty: any.
    std::string body;
    /// Name of the pair on whose slave the closest points are evaluated; empty: the probe is in a
    /// body.
    std::string        pair;
    dealii::Point<dim> point;
    /// Coordinates of the end of the line; empty: a single point.
    std::vector<double> end;
    /// Number of points of a line.
    unsigned int n_points = 21;

    /// @return whether the probe has several points.
    bool
    is_line() const
    {
      return !end.empty();
    }

    /// @return whether the probe is on a slave surface.
    bool
    is_on_pair() const
    {
      return !pair.empty();
    }

    /// Declare the keys and read their values. Throws SceneError.
    /// @param section of the probe
    void
    declare(Section &section);

    /// @return the points, including both ends of a line.
    std::vector<dealii::Point<dim>>
    points() const;

    /// @return one probe of a single point for each point.
    std::vector<Probe>
    single() const;

    /// @return the beginning of messages, "probe 'tip': ".
    std::string
    title() const;
  };

  template <int dim>
  using Probes = std::vector<Probe<dim>>;

  /// @return the probe of a name, which must exist.
  /// @param probes of the scene
  /// @param name of one of them
  template <int dim>
  const Probe<dim> &
  probe_named(const Probes<dim> &probes, const std::string &name);

  /// @return coordinates for messages, "(0.5, 2)".
  /// @param x a point
  template <int dim>
  std::string
  point_text(const dealii::Point<dim> &x);

  /// The distance, in units of a cell, that a point may be outside of its body or beside its
  /// surface, since meshes of curved bodies omit points near their true surface.
  constexpr double probe_tolerance = 0.02;
} // namespace Signorini
