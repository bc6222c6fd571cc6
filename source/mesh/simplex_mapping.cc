// SPDX-License-Identifier: Apache-2.0
#include "mesh/any_cell_mapping.h"

#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/grid/manifold.h>

#include <limits>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  SimplexMapping<dim>::SimplexMapping(const unsigned int               degree,
                                      const std::vector<unsigned int> &degree_of_material)
    : MappingFE<dim>(FE_SimplexP<dim>(degree))
    , degree_of_material(degree_of_material)
  {}



  template <int dim>
  std::unique_ptr<Mapping<dim>>
  SimplexMapping<dim>::clone() const
  {
    return std::make_unique<SimplexMapping<dim>>(this->get_degree(), degree_of_material);
  }



  // FE_SimplexP numbers its nodes by vertices, then lines.
  template <int dim>
  std::vector<Point<dim>>
  SimplexMapping<dim>::compute_mapping_support_points(
    const typename Triangulation<dim>::cell_iterator &cell) const
  {
    std::vector<Point<dim>> points;
    for (const unsigned int v : cell->vertex_indices())
      points.push_back(cell->vertex(v));
    if (this->get_degree() == 1)
      return points;
    const bool is_straight =
      !degree_of_material.empty() && degree_of_material.at(cell->material_id()) == 1;
    for (const unsigned int l : cell->line_indices())
      {
        const auto &line = cell->line(l);
        if (is_straight || line->manifold_id() == numbers::flat_manifold_id)
          points.push_back(0.5 * (line->vertex(0) + line->vertex(1)));
        else
          points.push_back(
            line->get_manifold().get_intermediate_point(line->vertex(0), line->vertex(1), 0.5));
      }
    return points;
  }



  // A straight simplex takes one step. Offsets from the first node avoid cancellation far from the
  // origin.
  template <int dim>
  Point<dim>
  SimplexMapping<dim>::transform_real_to_unit_cell(
    const typename Triangulation<dim>::cell_iterator &cell, const Point<dim> &x) const
  {
    const std::vector<Point<dim>> points = compute_mapping_support_points(cell);
    Point<dim>                    unit   = cell->reference_cell().template barycenter<dim>();
    const double                  size   = cell->diameter();
    double                        before = std::numeric_limits<double>::infinity();
    for (unsigned int step = 0; step < 20; ++step)
      {
        Tensor<1, dim> residual = x - points[0];
        Tensor<2, dim> slope;
        for (unsigned int i = 0; i < points.size(); ++i)
          {
            residual -= this->fe->shape_value(i, unit) * (points[i] - points[0]);
            slope += outer_product(points[i] - points[0], this->fe->shape_grad(i, unit));
          }
        if (!(determinant(slope) > 0))
          break;
        const double now = residual.norm();
        if (now <= 1e-15 * size || (now <= 1e-12 * size && now >= before))
          return unit;
        before = now;
        unit += invert(slope) * residual;
        if (unit.norm() > 10)
          break;
      }
    AssertThrow(before <= 1e-10 * size + 1e-14 * x.norm(),
                typename Mapping<dim>::ExcTransformationFailed());
    return unit;
  }



  template class SimplexMapping<2>;
  template class SimplexMapping<3>;
} // namespace Signorini
