#include "contact/interface/seams.h"

#include "contact/constraints/trace.h"

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  std::vector<Seam<dim>>
  make_seams(const Elasticity<dim>               &elasticity,
             const BoundaryFaces<dim>            &slave,
             const std::vector<PairedPoint<dim>> &paired)
  {
    Trace<dim>             trace(elasticity);
    std::vector<Seam<dim>> seams;
    for (std::size_t i = 0; i < paired.size(); ++i)
      {
        const PairedPoint<dim> &point = paired[i];
        if (i == 0 || point.face != paired[i - 1].face)
          trace.reinit(slave.faces[point.face].first, slave.faces[point.face].second);
        const Point<dim> at_rest = slave.rest[point.face].position(point.xi);
        seams.push_back({point.weight * measure(elasticity.model(), at_rest),
                         trace.functions(point.xi),
                         point.partner.functions,
                         point.partner.bend,
                         {},
                         point.face,
                         point.xi});
      }
    return seams;
  }



  template std::vector<Seam<2>>
  make_seams(const Elasticity<2> &, const BoundaryFaces<2> &, const std::vector<PairedPoint<2>> &);
  template std::vector<Seam<3>>
  make_seams(const Elasticity<3> &, const BoundaryFaces<3> &, const std::vector<PairedPoint<3>> &);
} // namespace Signorini
