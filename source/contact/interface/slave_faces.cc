// SPDX-License-Identifier: Apache-2.0
#include "contact/interface/surface_steps.h"
#include "geometry/cell_rule.h"

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  std::vector<SlaveFace<dim>>
  slave_faces(const Elasticity<dim>                &elasticity,
              const BoundaryFaces<dim>             &slave,
              const std::vector<ContactPoint<dim>> &points,
              const std::vector<PressureNodes>     &functions)
  {
    std::vector<SlaveFace<dim>> result(slave.faces.size());
    Trace<dim>                  trace(elasticity);
    // Each face that has points is completed at its first point.
    for (const ContactPoint<dim> &point : points)
      if (SlaveFace<dim> &face = result[point.face]; face.degree == 0)
        {
          const auto &[cell, f] = slave.faces[point.face];
          trace.reinit(cell, f);
          face.cell                 = cell->id();
          face.face                 = f;
          const ReferenceCell shape = shape_of_faces(cell->reference_cell());
          const unsigned int  k     = cell->get_fe().degree;
          face.degree               = is_triangle(shape) ? 1 : k;
          const auto node_at        = [&](const Point<dim - 1> &xi) {
            // At a node of the face one shape function is one and the others zero: its index is
            // that of the largest value.
            const SparseRow values = trace.unresolved_shape(xi);
            return std::max_element(values.begin(),
                                    values.end(),
                                    [](const auto &a, const auto &b) {
                                      return a.second < b.second;
                                    })
              ->first;
          };
          if constexpr (dim == 3)
            if (face.degree < k)
              for (const unsigned int side : shape.face_indices())
                {
                  const auto ends = ends_of_side<dim>(shape, side);
                  face.between.push_back({node_at(ends[0] + (ends[1] - ends[0]) / 2),
                                          {{shape.face_to_cell_vertices(side, 0, 1),
                                            shape.face_to_cell_vertices(side, 1, 1)}}});
                }
          for (const Point<dim - 1> &xi : face_lattice<dim>(shape, face.degree))
            {
              face.nodes.push_back(node_at(xi));
              face.positions.push_back(
                (elasticity.is_finite_strain() ? slave.patches : slave.rest)[point.face].position(
                  xi));
              const auto &own   = functions[point.face].own;
              const bool is_own = std::find(own.begin(), own.end(), face.nodes.back()) != own.end();
              // If all nodes of a face are prescribed, none of them counts as being without
              // pressure.
              face.without_pressure.push_back(!is_own && !own.empty());
              face.under_covered.push_back(
                face.without_pressure.back() &&
                carries_pressure(elasticity, face.nodes.back(), k, slave.patches[point.face], xi));
            }
          face.covered = functions[point.face].covered;
        }
    return result;
  }



  template <int dim>
  bool
  any_dirichlet_node(const std::vector<SlaveFace<dim>> &faces)
  {
    return std::any_of(faces.begin(), faces.end(), [](const SlaveFace<dim> &face) {
      return std::find(face.without_pressure.begin(), face.without_pressure.end(), true) !=
             face.without_pressure.end();
    });
  }



  template <int dim>
  std::vector<std::pair<SparseRow, double>>
  full_face_shape_functions(const Elasticity<dim> &elasticity, const BoundaryFaces<dim> &slave)
  {
    // Gauss quadrature of the whole reference area of each face, which is exact for the products of
    // shape functions on triangles and parallelograms.
    std::vector<std::pair<SparseRow, double>> result;
    Trace<dim>                                trace(elasticity);
    for (unsigned int i = 0; i < slave.faces.size(); ++i)
      {
        const Quadrature<dim - 1> &rule =
          cell_rule<dim - 1>(slave.rest[i].reference_cell(),
                             slave.faces[i].first->get_fe().degree + 1);
        trace.reinit(slave.faces[i].first, slave.faces[i].second);
        for (unsigned int q = 0; q < rule.size(); ++q)
          result.emplace_back(trace.shape(rule.point(q)),
                              rule.weight(q) * slave.rest[i].jacobian(rule.point(q)) *
                                measure(elasticity.model(), slave.rest[i].position(rule.point(q))));
      }
    return result;
  }



#define INSTANTIATE(dim)                                                                           \
  template bool                        any_dirichlet_node(const std::vector<SlaveFace<dim>> &);    \
  template std::vector<SlaveFace<dim>> slave_faces(const Elasticity<dim> &,                        \
                                                   const BoundaryFaces<dim> &,                     \
                                                   const std::vector<ContactPoint<dim>> &,         \
                                                   const std::vector<PressureNodes> &);            \
  template std::vector<std::pair<SparseRow, double>> full_face_shape_functions(                    \
    const Elasticity<dim> &, const BoundaryFaces<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
