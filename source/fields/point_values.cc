// SPDX-License-Identifier: Apache-2.0
#include "fields/point_values.h"

#include "contact/constraints/gap_increments.h"
#include "fields/nodal_fields.h"

namespace Signorini
{
  using namespace dealii;

  // Rows of methods that sample at points are the points themselves. For nodal methods the gap is
  // recomputed from the displacement, and the pressure is interpolated from the nodes; with a dual
  // basis by the interpolation functions of the point instead of the multiplier functions.
  template <int dim>
  PointValues
  point_values(const Snapshot<dim> &s, const unsigned int pair)
  {
    PointValues values;
    const auto &points = s.surfaces[pair].points;
    if (!samples_nodes(s.contact))
      {
        types::global_dof_index row = first_row(s, pair);
        for (unsigned int q = 0; q < points.size(); ++q, ++row)
          {
            values.gap.push_back(s.gap(row));
            values.pressure.push_back(s.pressure(row) / points[q].stretch);
          }
        return values;
      }
    // Nodal methods: the change of the gap at the points by the displacement of slave and master.
    std::vector<const ContactPoint<dim> *> places;
    for (const ContactPoint<dim> &point : points)
      places.push_back(&point);
    const std::vector<double> opened = gap_increments(places, s.displacement);
    auto                      change = opened.begin();
    const LA::Vector          p      = s.elasticity.with_ghosts(nodal_field(s, s.pressure, pair));
    // Ties that begin late have the gap since then.
    const bool       is_late = s.contact.gap_at_start.size() > 0;
    const LA::Vector start =
      is_late ? s.elasticity.with_ghosts(nodal_field(s, s.contact.gap_at_start, pair)) : p;
    for (const ContactPoint<dim> &point : points)
      {
        // While an interference is resolved step by step, only a fraction of an initial penetration
        // counts.
        const double share =
          point.gap < 0 && !s.contact.interference.empty() ? s.contact.interference[pair] : 1.;
        double gap      = share * point.gap + point.gap_offset + *change++;
        double pressure = 0;
        for (const auto &[node, value] :
             point.interpolation.empty() ? point.multiplier_shape : point.interpolation)
          {
            pressure += value * p(node);
            if (is_late)
              gap -= value * start(node);
          }
        values.gap.push_back(gap);
        values.pressure.push_back(pressure / point.stretch);
      }
    return values;
  }



  template PointValues
  point_values(const Snapshot<2> &, unsigned int);
  template PointValues
  point_values(const Snapshot<3> &, unsigned int);
} // namespace Signorini
