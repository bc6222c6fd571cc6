// SPDX-License-Identifier: Apache-2.0
#include "reference.h"

#include <deal.II/base/quadrature_lib.h>

#include <map>

namespace TestScene
{
  namespace
  {
    /// lambda delta_ij delta_kl + mu (delta_ik delta_jl + delta_il delta_jk) in space; plane
    /// stress: with sigma_zz = 0 by static condensation.
    double
    elasticity_tensor(const Model        model,
                      const Material    &material,
                      const unsigned int i,
                      const unsigned int j,
                      const unsigned int k,
                      const unsigned int l)
    {
      const double E = material.youngs_modulus, nu = material.poissons_ratio;
      const double G = E / 2 / (1 + nu), volumetric = E / 3 / (1 - 2 * nu);
      const auto   delta = [](const unsigned int a, const unsigned int b) {
        return a == b ? 1. : 0.;
      };
      const auto C = [&](const auto i, const auto j, const auto k, const auto l) {
        return (volumetric - 2 * G / 3) * delta(i, j) * delta(k, l) +
               G * (delta(i, k) * delta(j, l) + delta(i, l) * delta(j, k));
      };
      return model == Model::plane_stress ?
               C(i, j, k, l) - C(i, j, 2, 2) * C(2, 2, k, l) / C(2, 2, 2, 2) :
               C(i, j, k, l);
    }

    /// The strain of vector-valued shape function i, in space.
    template <int dim>
    Tensor<2, 3>
    strain_of(const FEValues<dim> &values,
              const Model          model,
              const unsigned int   i,
              const unsigned int   q)
    {
      Tensor<2, 3> strain;
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int d = 0; d < dim; ++d)
          {
            strain[c][d] += values.shape_grad_component(i, q, c)[d] / 2;
            strain[d][c] += values.shape_grad_component(i, q, c)[d] / 2;
          }
      if (model == Model::axisymmetric)
        strain[2][2] = values.shape_value_component(i, q, 0) / values.quadrature_point(q)[0];
      return strain;
    }

    double
    circle(const Model model, const double r)
    {
      return model == Model::axisymmetric ? 2 * numbers::PI * r : 1;
    }

    template <int dim>
    double
    work_of_tractions(const SmallScene<dim>                                &scene,
                      const typename DoFHandler<dim>::active_cell_iterator &cell,
                      const unsigned int                                    f,
                      const Load<dim>                                      &load,
                      const Vector<double>                                 &w,
                      const double                                          t)
    {
      FEFaceValues<dim> values(scene.mesh->mapping(),
                               cell->get_fe(),
                               QGauss<dim - 1>(cell->get_fe().degree + 3),
                               update_values | update_quadrature_points | update_normal_vectors |
                                 update_JxW_values);
      values.reinit(static_cast<const typename Triangulation<dim>::cell_iterator &>(cell), f);
      double sum = 0;
      for (const unsigned int q : values.quadrature_point_indices())
        {
          const Point<dim>    &x = values.quadrature_point(q);
          const Tensor<1, dim> force =
            load.traction.value(x, t) - load.pressure.value(x, t) * values.normal_vector(q);
          for (unsigned int i = 0; i < w.size(); ++i)
            for (unsigned int d = 0; d < dim; ++d)
              sum += force[d] * w[i] * values.shape_value_component(i, q, d) * values.JxW(q) *
                     circle(model_of(scene.scene.model), x[0]);
        }
      return sum;
    }

    template <int dim>
    double
    work_of_loads(const SmallScene<dim>                                &scene,
                  const typename DoFHandler<dim>::active_cell_iterator &cell,
                  const FEValues<dim>                                  &values,
                  const Vector<double>                                 &w,
                  const double                                          t)
    {
      double sum = 0;
      for (const Load<dim> &load : scene.scene.loads)
        {
          for (const std::string &body : load.bodies)
            if (scene.mesh->body_name(cell->material_id()) == body)
              for (const unsigned int q : values.quadrature_point_indices())
                for (unsigned int i = 0; i < w.size(); ++i)
                  for (unsigned int d = 0; d < dim; ++d)
                    sum += load.body_force.value(values.quadrature_point(q), t)[d] * w[i] *
                           values.shape_value_component(i, q, d) * values.JxW(q) *
                           circle(model_of(scene.scene.model), values.quadrature_point(q)[0]);
          for (const std::string &boundary : load.boundaries)
            for (const unsigned int f : cell->face_indices())
              if (cell->face(f)->at_boundary() &&
                  scene.mesh->boundary_ids(boundary).count(cell->face(f)->boundary_id()) > 0)
                sum += work_of_tractions(scene, cell, f, load, w, t);
        }
      return sum;
    }
  } // namespace



  template <int dim>
  FullMatrix<double>
  reference_matrix(const FEValues<dim> &values, const Model model, const Material &material)
  {
    const unsigned int n = values.dofs_per_cell;
    FullMatrix<double> K(n, n);
    for (const unsigned int q : values.quadrature_point_indices())
      for (unsigned int a = 0; a < n; ++a)
        {
          const Tensor<2, 3> strain = strain_of(values, model, a, q);
          Tensor<2, 3>       stress;
          for (unsigned int i = 0; i < 3; ++i)
            for (unsigned int j = 0; j < 3; ++j)
              for (unsigned int k = 0; k < 3; ++k)
                for (unsigned int l = 0; l < 3; ++l)
                  stress[i][j] += elasticity_tensor(model, material, i, j, k, l) * strain[k][l];
          stress *= values.JxW(q) * circle(model, values.quadrature_point(q)[0]);
          for (unsigned int b = 0; b < n; ++b)
            K(a, b) += scalar_product(stress, strain_of(values, model, b, q));
        }
    return K;
  }



  template <int dim>
  double
  reference_work(const SmallScene<dim> &scene, const Values &u, const Values &w, const double t)
  {
    const Model                          model = model_of(scene.scene.model);
    std::vector<types::global_dof_index> indices;
    Vector<double>                       u_cell, w_cell;
    double                               sum = 0;
    for (const auto &cell : scene.elasticity->dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          // The rule of the program: on curved cells there is none that is exact.
          FEValues<dim> values(scene.mesh->mapping(),
                               cell->get_fe(),
                               QGauss<dim>(cell->get_fe().degree + 1),
                               update_values | update_gradients | update_quadrature_points |
                                 update_JxW_values);
          values.reinit(static_cast<const typename Triangulation<dim>::cell_iterator &>(cell));
          indices.resize(cell->get_fe().n_dofs_per_cell());
          cell->get_dof_indices(indices);
          u_cell.reinit(indices.size());
          w_cell.reinit(indices.size());
          for (unsigned int i = 0; i < indices.size(); ++i)
            {
              u_cell[i] = u[indices[i]];
              w_cell[i] = w[indices[i]];
            }
          sum += reference_matrix(values, model, scene.elasticity->material(cell->material_id()))
                   .matrix_scalar_product(w_cell, u_cell);
          sum -= work_of_loads(scene, cell, values, w_cell, t);
        }
    return Utilities::MPI::sum(sum, MPI_COMM_WORLD);
  }



  template <int dim>
  template <typename F>
  Values
  ReferenceContact<dim>::mean(const F &f) const
  {
    Values sums(area.size(), 0.);
    for (unsigned int pair = 0; pair < shares.size(); ++pair)
      for (unsigned int q = 0; q < shares[pair].size(); ++q)
        for (const auto &[place, share] : shares[pair][q])
          sums[place] += share * f(surfaces[pair].points[q]);
    Utilities::MPI::sum(sums, MPI_COMM_WORLD, sums);
    for (unsigned int i = 0; i < sums.size(); ++i)
      sums[i] /= area[i];
    return sums;
  }



  template <int dim>
  ReferenceContact<dim>::ReferenceContact(const SmallScene<dim> &scene)
    : surfaces(scene.contact->surfaces())
    , theta(scene.method().theta())
  {
    const GapOperator &contact = scene.gap_operator();
    const bool         nodal   = scene.method().sampling() == Sampling::nodes;

    // Numbers of nodes' places are on all ranks those that their owners gave them.
    std::vector<std::array<types::global_dof_index, 3>> own, all;
    unsigned int                                        local = 0;
    for (const auto row : contact.weight.locally_owned_elements())
      {
        own.push_back({{contact.origin.pair[local], nodal ? contact.origin.node[local] : 0, row}});
        ++local;
      }
    for (const auto &some : Utilities::MPI::all_gather(MPI_COMM_WORLD, own))
      all.insert(all.end(), some.begin(), some.end());
    std::map<std::pair<unsigned int, types::global_dof_index>, unsigned int> place;
    if (nodal)
      for (const auto &[pair, node, row] : all)
        place[{pair, node}] = row;

    const IndexSet owned   = contact.weight.locally_owned_elements();
    auto           own_row = owned.begin();
    for (unsigned int pair = 0; pair < surfaces.size(); ++pair)
      {
        shares.emplace_back();
        for (const ContactPoint<dim> &point : surfaces[pair].points)
          {
            shares.back().emplace_back();
            if (!nodal)
              shares.back().back().emplace_back(*own_row++, point.weight);
            else
              for (const auto &[node, psi] : point.multiplier_shape)
                if (const auto found = place.find({pair, node}); found != place.end())
                  shares.back().back().emplace_back(found->second, psi * point.weight);
          }
      }
    area.assign(all.size(), 1.);
    Values whole      = mean([](const auto &) { return 1.; });
    area              = whole;
    stiffness         = mean([](const auto &point) { return point.stiffness; });
    const double size = scene.mesh->size();
    epsilon           = mean([&](const auto &point) {
      return scene.method().penalty({point.stiffness, size / point.depth, point.bound});
    });
  }



  template <int dim>
  Values
  ReferenceContact<dim>::gap(const Values &u) const
  {
    return mean([&](const ContactPoint<dim> &point) { return point.gap + at(point.row(), u); });
  }



  namespace
  {
    /// The row of the normal stress; empty unless the method uses it.
    template <int dim>
    SparseRow
    normal_stress(const ContactPoint<dim> &point)
    {
      return point.stress.empty() ? SparseRow() : point.stress[0].displacement;
    }
  } // namespace



  template <int dim>
  Values
  ReferenceContact<dim>::stress(const Values &u) const
  {
    return mean([&](const ContactPoint<dim> &point) { return at(normal_stress(point), u); });
  }



  template <int dim>
  double
  ReferenceContact<dim>::work(const Values &p, const Values &s, const Values &w) const
  {
    double sum = 0;
    for (unsigned int pair = 0; pair < shares.size(); ++pair)
      for (unsigned int q = 0; q < shares[pair].size(); ++q)
        for (const auto &[place, share] : shares[pair][q])
          {
            const ContactPoint<dim> &point = surfaces[pair].points[q];
            sum -= share *
                   (p[place] * at(point.row(), w) +
                    theta * (s[place] - p[place]) / epsilon[place] * at(normal_stress(point), w));
          }
    return Utilities::MPI::sum(sum, MPI_COMM_WORLD);
  }



  template FullMatrix<double>
  reference_matrix(const FEValues<2> &, Model, const Material &);
  template FullMatrix<double>
  reference_matrix(const FEValues<3> &, Model, const Material &);
  template double
  reference_work(const SmallScene<2> &, const Values &, const Values &, double);
  template double
  reference_work(const SmallScene<3> &, const Values &, const Values &, double);
  template class ReferenceContact<2>;
  template class ReferenceContact<3>;
} // namespace TestScene
