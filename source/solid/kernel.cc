// SPDX-License-Identifier: Apache-2.0
#include "solid/kernel.h"

#include "solid/nan_check.h"
#include "solid/scalar_elements.h"

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Evaluate the finite element values on a cell of the mesh (the values refer to the scalar
    /// element and not to the DoFHandler's), with the element, mapping and rule of the cell's
    /// degree.
    template <int dim>
    const FEValues<dim> &
    reinit(hp::FEValues<dim> &values, const typename DoFHandler<dim>::active_cell_iterator &cell)
    {
      const auto i = cell->active_fe_index();
      values.reinit(static_cast<const typename Triangulation<dim>::cell_iterator &>(cell), i, 0, i);
      return values.get_present_fe_values();
    }

    /// Evaluate the face values on a face of a cell, in the same way.
    template <int dim>
    const FEFaceValues<dim> &
    reinit(hp::FEFaceValues<dim>                                &values,
           const typename DoFHandler<dim>::active_cell_iterator &cell,
           const unsigned int                                    face)
    {
      const auto i = cell->active_fe_index();
      values.reinit(
        static_cast<const typename Triangulation<dim>::cell_iterator &>(cell), face, i, 0, i);
      return values.get_present_fe_values();
    }
  } // namespace



  template <int dim>
  StiffnessKernel<dim>::StiffnessKernel(const Mesh<dim>             &mesh,
                                        const hp::FECollection<dim> &elements,
                                        const Model                  model)
    : model(model)
    , scalars(scalar_elements(elements))
    , all_values(mesh.mappings(),
                 scalars,
                 gauss_rules(elements, 1),
                 update_gradients | update_JxW_values |
                   (model == Model::axisymmetric ? update_values | update_quadrature_points :
                                                   update_default))
    , dofs(dofs_of_nodes(elements))
  {}



  // Element stiffness by the blocks of pairs of nodes (doc/theory, (1.5)): one tensor G of scalar
  // gradients yields dim^2 entries. Only pairs j <= i are integrated; the matrix is symmetric.
  template <int dim>
  void
  StiffnessKernel<dim>::assemble(const Cell         &cell,
                                 const Material     &material,
                                 FullMatrix<double> &cell_matrix)
  {
    const FEValues<dim> &values = reinit(all_values, cell);
    const double         lambda = in_plane_lambda(model, material), mu = material.mu();
    const auto          &dof = dofs[cell->active_fe_index()];
    const unsigned int   n   = dof.size() / dim;
    // Quadrature weights with the circumference 2 pi r in axisymmetric models, where volumes are
    // those of rings.
    weights = values.get_JxW_values();
    if (model == Model::axisymmetric)
      for (const unsigned int q : values.quadrature_point_indices())
        weights[q] *= measure(model, values.quadrature_point(q));

    cell_matrix.reinit(dof.size(), dof.size());
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j <= i; ++j)
        {
          // G = int grad N_i (x) grad N_j dV, from which all dim^2 entries of the pair follow:
          // K_ab = lambda G_ab + mu G_ba + mu tr(G) delta_ab.
          Tensor<2, dim> G;
          for (const unsigned int q : values.quadrature_point_indices())
            {
              const Tensor<1, dim>  weighted = values.shape_grad(i, q) * weights[q];
              const Tensor<1, dim> &other    = values.shape_grad(j, q);
              for (unsigned int a = 0; a < dim; ++a)
                for (unsigned int b = 0; b < dim; ++b)
                  G[a][b] += weighted[a] * other[b];
            }
          const double mu_trace = mu * trace(G);
          for (unsigned int a = 0; a < dim; ++a)
            for (unsigned int b = 0; b < dim; ++b)
              {
                const double       k   = lambda * G[a][b] + mu * G[b][a] + (a == b ? mu_trace : 0);
                const unsigned int row = dof[i * dim + a], column = dof[j * dim + b];
                cell_matrix(row, column) = k;
                cell_matrix(column, row) = k;
              }
        }
    if (model == Model::axisymmetric)
      add_hoop(dof, lambda, mu, cell_matrix);
  }



  // The hoop strain u_r/r of axisymmetric models (doc/theory, (1.7)). With h_i = N_i/r, the radial
  // component of node i has the hoop strain h_i, so that K_ab += int lambda (d_a N_i h_j delta_b0 +
  // h_i d_b N_j delta_a0) + (lambda + 2 mu) h_i h_j delta_a0 delta_b0. Gauss points are inside of
  // cells, so that r > 0.
  template <int dim>
  void
  StiffnessKernel<dim>::add_hoop(const std::vector<unsigned int> &dof,
                                 const double                     lambda,
                                 const double                     mu,
                                 FullMatrix<double>              &cell_matrix)
  {
    const FEValues<dim> &values = all_values.get_present_fe_values();
    const unsigned int   n      = dof.size() / dim;
    for (const unsigned int q : values.quadrature_point_indices())
      {
        // All pairs (i, j) and not only j <= i: the terms of both orders are different and together
        // symmetric.
        const double r = values.quadrature_point(q)[0];
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j < n; ++j)
            {
              const double h_i = values.shape_value(i, q) / r, h_j = values.shape_value(j, q) / r;
              const unsigned int row = dof[i * dim], column = dof[j * dim];
              cell_matrix(row, column) += (lambda + 2 * mu) * h_i * h_j * weights[q];
              for (unsigned int a = 0; a < dim; ++a)
                {
                  cell_matrix(dof[i * dim + a], column) +=
                    lambda * values.shape_grad(i, q)[a] * h_j * weights[q];
                  cell_matrix(row, dof[j * dim + a]) +=
                    lambda * h_i * values.shape_grad(j, q)[a] * weights[q];
                }
            }
      }
  }



  // Loads are integrated over the true surface and the volume that it encloses, with one Gauss
  // point more in each direction than the stiffness, because formulas are no polynomials.
  template <int dim>
  LoadKernel<dim>::LoadKernel(const Mesh<dim>              &mesh,
                              const hp::FECollection<dim>  &elements,
                              const Model                   model,
                              const std::vector<Load<dim>> &loads,
                              const double                  t,
                              const unsigned int            more_points)
    : model(model)
    , t(t)
    , nodal_forces(mesh, loads)
    , surface_loads(mesh, elements, model, loads, t)
    , scalars(scalar_elements(elements))
    , all_values(mesh.surface_mappings(),
                 scalars,
                 gauss_rules(elements, 2 + more_points),
                 update_values | update_quadrature_points | update_JxW_values)
    , all_face_values(mesh.surface_mappings(),
                      scalars,
                      gauss_rules_of_faces(elements, 2 + more_points),
                      update_values | update_quadrature_points | update_normal_vectors |
                        update_JxW_values)
  {
    // Body forces are sorted by material id for whole bodies and by coarse cell for sets of cells,
    // so that a cell finds its own without a search.
    for (const Load<dim> &load : loads)
      {
        const std::set<std::string> names(load.bodies.begin(), load.bodies.end());
        for (unsigned int id = 0; id < mesh.n_materials(); ++id)
          if (names.count(mesh.body_name(mesh.body_of_material(id))) > 0)
            by_material[id].push_back(&load);
        std::set<types::coarse_cell_id> cells;
        for (const std::string &name : names)
          if (name.find('.') != std::string::npos)
            cells.merge(mesh.cell_set(name));
        for (const types::coarse_cell_id cell : cells)
          by_cell[cell].push_back(&load);
      }
  }



  // Body forces, nodal forces and surface loads of a cell, in this order. Returns false if the cell
  // has none of them, so that the caller need not distribute zeros.
  template <int dim>
  bool
  LoadKernel<dim>::assemble(const Cell &cell, Vector<double> &cell_load)
  {
    cell_load.reinit(cell->get_fe().n_dofs_per_cell());
    bool loaded = false;
    for (const Load<dim> *load : body_forces(cell))
      {
        add_body_force(cell, *load, cell_load);
        loaded = true;
      }
    if (nodal_forces.on(cell->active_cell_index()))
      {
        add_nodal_forces(cell, cell_load);
        loaded = true;
      }
    if (!surface_loads.empty() && cell->at_boundary())
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary() && surface_loads.act_on(cell->face(f)->boundary_id()))
          {
            add_surface_loads(cell, f, cell_load);
            loaded = true;
          }
    return loaded;
  }



  // Keep a message for the first value that is not finite. It is thrown later on all ranks
  // together, since an exception on one of them would leave the others waiting.
  template <int dim>
  void
  LoadKernel<dim>::check(const double       size,
                         const Load<dim>   &load,
                         const std::string &key,
                         const std::string &formula,
                         const Point<dim>  &x)
  {
    if (!std::isfinite(size) && error_message.empty())
      error_message = not_finite("Loads/" + load.name + "/" + key, formula, x, t);
  }



  template <int dim>
  // A load that names both a body and a set of its cells acts once.
  std::vector<const Load<dim> *>
  LoadKernel<dim>::body_forces(const Cell &cell) const
  {
    std::vector<const Load<dim> *> result;
    if (const auto found = by_material.find(cell->material_id()); found != by_material.end())
      result = found->second;
    if (by_cell.empty())
      return result;
    if (const auto found = by_cell.find(cell->id().get_coarse_cell_id()); found != by_cell.end())
      for (const Load<dim> *load : found->second)
        if (std::find(result.begin(), result.end(), load) == result.end())
          result.push_back(load);
    return result;
  }



  // int b . N_i dV with k + 2 Gauss points in each direction for degree k, since b is a formula of
  // the position.
  template <int dim>
  void
  LoadKernel<dim>::add_body_force(const Cell      &cell,
                                  const Load<dim> &load,
                                  Vector<double>  &cell_load)
  {
    const FEValues<dim> &values = reinit(all_values, cell);
    for (const unsigned int q : values.quadrature_point_indices())
      {
        const Point<dim>    &x       = values.quadrature_point(q);
        const Tensor<1, dim> density = load.body_force_at(x, t);
        check(density.norm(), load, "Body force", load.body_force.text(), x);
        const Tensor<1, dim> force = density * values.JxW(q) * measure(model, x);
        for (const unsigned int i : values.dof_indices())
          for (unsigned int d = 0; d < dim; ++d)
            cell_load[cell->get_fe().component_to_system_index(d, i)] +=
              force[d] * values.shape_value(i, q);
      }
  }



  // A force at a point of a cell is distributed by the shape functions there; at a node it acts on
  // that node alone.
  template <int dim>
  void
  LoadKernel<dim>::add_nodal_forces(const Cell &cell, Vector<double> &cell_load)
  {
    const FiniteElement<dim> &fe = cell->get_fe();
    for (const auto &one : *nodal_forces.on(cell->active_cell_index()))
      {
        const Tensor<1, dim> force = one.value(t);
        check(one.load->force_at(one.position, t).norm(),
              *one.load,
              "Force",
              one.load->force.text(),
              one.position);
        check(force.norm(), *one.load, "Total force", one.load->total_force.text(), one.position);
        for (unsigned int i = 0; i < fe.base_element(0).n_dofs_per_cell(); ++i)
          for (unsigned int d = 0; d < dim; ++d)
            cell_load[fe.component_to_system_index(d, i)] +=
              force[d] * fe.base_element(0).shape_value(i, one.unit);
      }
  }



  // int (t - p N) . N_i dA over a face of the true boundary (doc/theory, (1.4)).
  template <int dim>
  void
  LoadKernel<dim>::add_surface_loads(const Cell        &cell,
                                     const unsigned int face,
                                     Vector<double>    &cell_load)
  {
    const FEFaceValues<dim> &face_values = reinit(all_face_values, cell, face);
    for (const unsigned int q : face_values.quadrature_point_indices())
      {
        const Point<dim>    &x = face_values.quadrature_point(q);
        const Tensor<1, dim> force =
          face_values.JxW(q) * measure(model, x) *
          surface_loads.at(*cell, face, x).on(face_values.normal_vector(q));
        for (const unsigned int i : face_values.dof_indices())
          for (unsigned int d = 0; d < dim; ++d)
            cell_load[cell->get_fe().component_to_system_index(d, i)] +=
              force[d] * face_values.shape_value(i, q);
      }
  }



  template class StiffnessKernel<2>;
  template class StiffnessKernel<3>;
  template class LoadKernel<2>;
  template class LoadKernel<3>;
} // namespace Signorini
