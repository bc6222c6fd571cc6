// SPDX-License-Identifier: Apache-2.0
#include "contact/constraints/trace.h"
#include "contact/interface/surface_steps.h"

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  std::vector<EdgeContactPoint<dim>>
  make_edge_points(const Elasticity<dim>               &elasticity,
                   const BoundaryFaces<dim>            &slave,
                   const std::vector<PairedPoint<dim>> &paired)
  {
    Trace<dim>                         trace(elasticity);
    std::vector<EdgeContactPoint<dim>> edge_points;
    for (std::size_t i = 0; i < paired.size(); ++i)
      {
        // The trace is evaluated once for each slave face, by which the points are sorted.
        const PairedPoint<dim> &point = paired[i];
        if (i == 0 || point.face != paired[i - 1].face)
          trace.reinit(slave.faces[point.face].first, slave.faces[point.face].second);
        const Point<dim> at_rest = slave.rest[point.face].position(point.xi);
        edge_points.push_back({point.weight * measure(elasticity.model(), at_rest),
                               trace.functions(point.xi),
                               point.master_point.functions,
                               point.master_point.second_variation,
                               {},
                               point.face,
                               point.xi});
      }
    return edge_points;
  }



  template std::vector<EdgeContactPoint<2>>
  make_edge_points(const Elasticity<2> &,
                   const BoundaryFaces<2> &,
                   const std::vector<PairedPoint<2>> &);
  template std::vector<EdgeContactPoint<3>>
  make_edge_points(const Elasticity<3> &,
                   const BoundaryFaces<3> &,
                   const std::vector<PairedPoint<3>> &);
} // namespace Signorini
