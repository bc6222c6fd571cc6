// SPDX-License-Identifier: Apache-2.0
#include "solid/fluid_faces.h"

#include "solid/cell_nodes.h"
#include "solid/gradient_at_point.h"
#include "solid/scalar_elements.h"
#include "solid/wet_faces.h"

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  double
  FluidFace<dim>::distance(const Point<dim> &x) const
  {
    const auto &of_mesh = cell->face(number);
    double      result  = middle.distance(x);
    for (const unsigned int v : of_mesh->vertex_indices())
      result = std::min(result, of_mesh->vertex(v).distance(x));
    return result;
  }



  template <int dim>
  FluidFaces<dim>::FluidFaces(const Elasticity<dim> &elasticity, const Load<dim> &load)
    : elasticity(elasticity)
    , elements(scalar_elements(elasticity.finite_elements()))
    , all_values(elasticity.mesh().surface_mappings(),
                 elements,
                 gauss_rules_of_faces(elasticity.finite_elements(), 2),
                 update_values | update_quadrature_points | update_normal_vectors |
                   update_JxW_values)
    , all_gradients(elasticity.mesh().mappings(),
                    elements,
                    gauss_rules_of_faces(elasticity.finite_elements(), 2),
                    update_values | update_gradients | update_quadrature_points)
    , all_dofs(dofs_of_nodes(elasticity.finite_elements()))
  {
    const BoundaryIds ids = boundaries_of(elasticity.mesh(), load);
    for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned() && cell->at_boundary())
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary() && ids.count(cell->face(f)->boundary_id()) > 0)
            add_face(cell, f, pressure_acts(load, *cell, f));
  }



  template <int dim>
  void
  FluidFaces<dim>::add_face(const Cell &cell, const unsigned int f, const bool is_wet)
  {
    FluidFace<dim> face{cell, f, {}, cell->face(f)->center(), 0, is_wet};
    for (const unsigned int v : cell->face(f)->vertex_indices())
      face.vertices.push_back(cell->vertex_dof_index(
        cell->reference_cell().face_to_cell_vertices(f, v, 1), 0, cell->active_fe_index()));
    const typename Triangulation<dim>::cell_iterator &of_mesh = cell;
    all_values.reinit(of_mesh, f, cell->active_fe_index(), 0, cell->active_fe_index());
    const FEFaceValues<dim> &values = all_values.get_present_fe_values();
    for (const unsigned int q : values.quadrature_point_indices())
      face.area += values.JxW(q) * measure(elasticity.model(), values.quadrature_point(q));
    all.push_back(face);
  }



  template <int dim>
  template <typename Act>
  void
  FluidFaces<dim>::visit(const LA::Vector &ghosted, const Act &act)
  {
    Vector<double> values_of_u;
    for (FluidFace<dim> &face : all)
      {
        const unsigned int                                i       = face.cell->active_fe_index();
        const typename Triangulation<dim>::cell_iterator &of_mesh = face.cell;
        all_values.reinit(of_mesh, face.number, i, 0, i);
        all_gradients.reinit(of_mesh, face.number, i, 0, i);
        const FEFaceValues<dim> &values    = all_values.get_present_fe_values();
        const auto              &gradients = all_gradients.get_present_fe_values();
        const auto              &dofs      = all_dofs[i];
        values_of_u.reinit(dofs.size());
        face.cell->get_dof_values(ghosted, values_of_u);
        std::vector<Tensor<1, dim>> areas(dofs.size() / dim);
        for (const unsigned int q : values.quadrature_point_indices())
          {
            Tensor<1, dim> n = values.normal_vector(q);
            if (elasticity.is_finite_strain())
              {
                // Nanson: n da = J F^-T N dA.
                const Tensor<2, 3> F =
                  gradient_at_point(elasticity.model(), gradients, dofs, q, values_of_u);
                const Tensor<2, 3> G = determinant(F) * invert(F);
                n                    = 0;
                for (unsigned int a = 0; a < dim; ++a)
                  for (unsigned int K = 0; K < dim; ++K)
                    n[a] += G[K][a] * values.normal_vector(q)[K];
              }
            const double dA =
              values.JxW(q) * measure(elasticity.model(), values.quadrature_point(q));
            for (unsigned int k = 0; k < areas.size(); ++k)
              areas[k] += values.shape_value(k, q) * dA * n;
          }
        act(face, dofs, areas);
      }
  }



  template <int dim>
  LA::Vector
  FluidFaces<dim>::with_hanging_nodes(LA::Vector v) const
  {
    elasticity.hanging_nodes().distribute(v);
    return elasticity.with_ghosts(v);
  }



  template <int dim>
  std::vector<std::vector<double>>
  FluidFaces<dim>::pressures(const LA::Vector &u, const std::vector<const LA::Vector *> &forces)
  {
    const LA::Vector ghosted = elasticity.with_ghosts(u);
    LA::Vector       area    = elasticity.zero_vector();
    visit(ghosted, [&](const FluidFace<dim> &face, const auto &dofs, const auto &areas) {
      Vector<double> of_cell(face.cell->get_fe().n_dofs_per_cell());
      for (unsigned int i = 0; i < areas.size(); ++i)
        for (unsigned int d = 0; d < dim; ++d)
          of_cell(dofs[i * dim + d]) = areas[i][d];
      read_indices<dim>(face.cell, indices);
      elasticity.hanging_nodes().distribute_local_to_global(of_cell, indices, area);
    });
    area.compress(VectorOperation::add);
    // Hanging nodes have no forces of their own: they get the means of forces and areas, before
    // these are divided.
    const LA::Vector        of_nodes = with_hanging_nodes(area);
    std::vector<LA::Vector> at_nodes;
    at_nodes.reserve(forces.size());
    for (const LA::Vector *force : forces)
      at_nodes.push_back(with_hanging_nodes(*force));
    std::vector<std::vector<double>> result(forces.size());
    visit(ghosted, [&](const FluidFace<dim> &face, const auto &dofs, const auto &areas) {
      read_indices<dim>(face.cell, indices);
      Tensor<1, dim> sum;
      for (const Tensor<1, dim> &one : areas)
        sum += one;
      const Tensor<1, dim> n     = sum / sum.norm();
      const auto           along = [&](const LA::Vector &v, const unsigned int node) {
        double component = 0;
        for (unsigned int d = 0; d < dim; ++d)
          component += v(indices[dofs[node * dim + d]]) * n[d];
        return component;
      };
      for (unsigned int k = 0; k < forces.size(); ++k)
        {
          double pressure = 0;
          for (unsigned int i = 0; i < areas.size(); ++i)
            if (areas[i].norm() > 0)
              if (const double extent = along(of_nodes, i); extent > 0)
                pressure -= (areas[i] * n) / (sum * n) * along(at_nodes[k], i) / extent;
          result[k].push_back(pressure);
        }
    });
    return result;
  }



  template struct FluidFace<2>;
  template struct FluidFace<3>;
  template class FluidFaces<2>;
  template class FluidFaces<3>;
} // namespace Signorini
