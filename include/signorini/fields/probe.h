// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/point.h>

#include <string>
#include <vector>

namespace Signorini
{
  class Section;

  /// A named point, or points along a straight line, of a body or of the slave of a pair, at rest.
  template <int dim>
  struct Probe
  {
    std::string         name;
    std::string         body; ///< empty: any
    std::string         pair; ///< not empty: where its slave is closest
    dealii::Point<dim>  point;
    std::vector<double> end;           ///< coordinates of the end of the line; empty: a point alone
    unsigned int        n_points = 21; ///< of a line

    bool
    is_line() const
    {
      return !end.empty();
    }

    bool
    is_on_pair() const
    {
      return !pair.empty();
    }

    /// Throws SceneError.
    void
    declare(Section &section);

    /// Both ends of a line included.
    std::vector<dealii::Point<dim>>
    points() const;

    /// One for each of the points.
    std::vector<Probe>
    single() const;

    /// "probe 'tip': "
    std::string
    title() const;
  };

  template <int dim>
  using Probes = std::vector<Probe<dim>>;

  /// The one of that name, which is there.
  template <int dim>
  const Probe<dim> &
  probe_named(const Probes<dim> &probes, const std::string &name);

  /// "(0.5, 2)"
  template <int dim>
  std::string
  point_text(const dealii::Point<dim> &x);

  /// What a point may be outside of its body, or beside its surface, in cells: as meshes of curved
  /// bodies leave out points near their true surface.
  constexpr double probe_tolerance = 0.02;
} // namespace Signorini
