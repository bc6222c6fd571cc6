// SPDX-License-Identifier: Apache-2.0
#include "solid/pressure_kernel.h"

#include "solid/gradient_at_point.h"
#include "solid/nan_check.h"
#include "solid/scalar_elements.h"
#include "solid/wet_faces.h"

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// True if the load is a pressure on boundaries, which follows the surface at finite strain.
    template <int dim>
    bool
    is_follower_load(const Load<dim> &load)
    {
      return !load.boundaries.empty() && !load.pressure.is_zero();
    }
  } // namespace



  // At finite strain pressures follow the surface, see PressureKernel; other loads keep their
  // direction and their amount per reference area.
  template <int dim>
  std::vector<Load<dim>>
  dead_loads(const Elasticity<dim> &elasticity)
  {
    std::vector<Load<dim>> result = elasticity.loads();
    // The pressure of each load is removed, and its traction and other forces remain.
    if (elasticity.is_finite_strain())
      for (Load<dim> &load : result)
        load.pressure = Expression<dim>();
    return result;
  }



  template <int dim>
  bool
  has_follower_pressures(const Elasticity<dim> &elasticity)
  {
    return elasticity.is_finite_strain() &&
           std::any_of(elasticity.loads().begin(), elasticity.loads().end(), is_follower_load<dim>);
  }



  // Two sets of values on the same points: positions, normals and areas of the true surface, and
  // gradients by the mapping of the cell, in which the displacement is defined.
  template <int dim>
  PressureKernel<dim>::PressureKernel(const Elasticity<dim> &elasticity)
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
    if (!has_follower_pressures(elasticity))
      return;
    for (const Load<dim> &load : elasticity.loads())
      if (is_follower_load(load))
        for (const types::boundary_id id : boundaries_of(elasticity.mesh(), load))
          by_boundary[id].push_back(&load);
  }



  // The sum of the pressures of several loads on the same boundary at the reference position x; the
  // first value that is not finite is kept as a message.
  template <int dim>
  double
  PressureKernel<dim>::pressure(const Loads &loads, const Point<dim> &x)
  {
    const double t   = elasticity.time();
    double       sum = 0;
    for (const Load<dim> *load : loads)
      {
        const double p = load->pressure.value(x, t);
        if (!std::isfinite(p) && error_message.empty())
          error_message =
            not_finite("Loads/" + load->name + "/Pressure", load->pressure.formula(), x, t);
        sum += p;
      }
    return sum;
  }



  // Follower pressures on all boundary faces of a cell. Returns false, with `forces` unchanged, if
  // there are none, as for almost all cells.
  template <int dim>
  bool
  PressureKernel<dim>::assemble(const Cell           &cell,
                                const Vector<double> &u,
                                Vector<double>       &forces,
                                FullMatrix<double>   *tangent)
  {
    if (empty() || !cell->at_boundary())
      return false;
    bool acts = false;
    for (const unsigned int f : cell->face_indices())
      {
        const auto found = by_boundary.find(cell->face(f)->boundary_id());
        if (!cell->face(f)->at_boundary() || found == by_boundary.end())
          continue;
        Loads acting;
        for (const Load<dim> *load : found->second)
          if (pressure_acts(*load, *cell, f))
            acting.push_back(load);
        if (acting.empty())
          continue;
        const auto i = cell->active_fe_index();
        dofs         = &all_dofs[i];
        if (!acts)
          {
            forces.reinit(dofs->size());
            if (tangent)
              tangent->reinit(dofs->size(), dofs->size());
          }
        acts                                                      = true;
        const typename Triangulation<dim>::cell_iterator &of_mesh = cell;
        all_values.reinit(of_mesh, f, i, 0, i);
        all_gradients.reinit(of_mesh, f, i, 0, i);
        values    = &all_values.get_present_fe_values();
        gradients = &all_gradients.get_present_fe_values();
        add_face(acting, u, forces, tangent);
      }
    return acts;
  }



  // Follower pressure: forces (6.4) and their derivative (6.5), integrated over the reference face.
  template <int dim>
  void
  PressureKernel<dim>::add_face(const Loads          &loads,
                                const Vector<double> &u,
                                Vector<double>       &forces,
                                FullMatrix<double>   *tangent)
  {
    const Model        model   = elasticity.model();
    const unsigned int n_nodes = dofs->size() / dim;
    for (const unsigned int q : values->quadrature_point_indices())
      {
        const Point<dim>  &x = values->quadrature_point(q);
        const Tensor<2, 3> F = gradient_at_point(model, *gradients, *dofs, q, u), G = invert(F);
        // Nanson: the current area element n da is J F^-T N dA. The pressure acts against the
        // outward normal, hence the minus sign.
        const double weight =
          -pressure(loads, x) * determinant(F) * values->JxW(q) * measure(model, x);
        // Normals have no hoop component, so that the in-plane part of F^-T suffices.
        const auto pulled_back = [&](const Tensor<1, dim> &at_rest) {
          Tensor<1, dim> result; // F^-T v
          for (unsigned int a = 0; a < dim; ++a)
            for (unsigned int K = 0; K < dim; ++K)
              result[a] += G[K][a] * at_rest[K];
          return result;
        };
        const Tensor<1, dim> n = pulled_back(values->normal_vector(q));
        for (unsigned int i = 0; i < n_nodes; ++i)
          for (unsigned int a = 0; a < dim; ++a)
            forces((*dofs)[i * dim + a]) += weight * values->shape_value(i, q) * n[a];
        if (!tangent)
          continue;
        for (unsigned int j = 0; j < n_nodes; ++j)
          {
            // The derivative of J F^-T N along w is J (tr(Grad w F^-1) F^-T N - F^-T (Grad w)^T
            // F^-T N). With w = N_j e_b the second term is (F^-T grad N_j)_a n_b.
            const Tensor<1, dim> slope = pulled_back(gradients->shape_grad(j, q));
            // tr(Grad w F^-1) of w = N_j e_b, with the hoop part of axisymmetric models.
            Tensor<1, dim> volume = slope;
            if (model == Model::axisymmetric)
              volume[0] += values->shape_value(j, q) / gradients->quadrature_point(q)[0] * G[2][2];
            for (unsigned int i = 0; i < n_nodes; ++i)
              for (unsigned int a = 0; a < dim; ++a)
                for (unsigned int b = 0; b < dim; ++b)
                  (*tangent)((*dofs)[i * dim + a], (*dofs)[j * dim + b]) +=
                    weight * values->shape_value(i, q) * (volume[b] * n[a] - slope[a] * n[b]);
          }
      }
  }



  template std::vector<Load<2>>
  dead_loads(const Elasticity<2> &);
  template std::vector<Load<3>>
  dead_loads(const Elasticity<3> &);
  template bool
  has_follower_pressures(const Elasticity<2> &);
  template bool
  has_follower_pressures(const Elasticity<3> &);
  template class PressureKernel<2>;
  template class PressureKernel<3>;
} // namespace Signorini
