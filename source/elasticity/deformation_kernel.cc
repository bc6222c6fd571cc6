#include <signorini/elasticity/deformation_kernel.h>
#include <signorini/elasticity/scalar_elements.h>

#include <stdexcept>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  DeformationKernel<dim>::DeformationKernel(const Mesh<dim>             &mesh,
                                            const hp::FECollection<dim> &all_elements,
                                            const Model                  model)
    : model(model)
    , n_components(dim * dim + (model == Model::axisymmetric ? 1 : 0))
    , elements(scalar_elements(all_elements))
    , all_values(mesh.mappings(),
                 elements,
                 gauss_rules(all_elements, 1),
                 update_values | update_gradients | update_JxW_values | update_quadrature_points)
    , all_dofs(dofs_of_nodes(all_elements))
  {}



  template <int dim>
  void
  DeformationKernel<dim>::reinit(const Cell &cell)
  {
    const auto i = cell->active_fe_index();
    all_values.reinit(static_cast<const typename Triangulation<dim>::cell_iterator &>(cell),
                      i,
                      0,
                      i);
    values = &all_values.get_present_fe_values();
    dofs   = &all_dofs[i];
  }



  template <int dim>
  Tensor<2, 3>
  DeformationKernel<dim>::gradient(const unsigned int q, const Vector<double> &u) const
  {
    Tensor<2, dim> gradient;
    Tensor<1, dim> value;
    for (unsigned int i = 0; i < dofs->size() / dim; ++i)
      for (unsigned int a = 0; a < dim; ++a)
        {
          const double at_node = u((*dofs)[i * dim + a]);
          gradient[a] += at_node * values->shape_grad(i, q);
          value[a] += at_node * values->shape_value(i, q);
        }
    return deformation_gradient(model, gradient, value, values->quadrature_point(q));
  }



  template <int dim>
  typename DeformationKernel<dim>::Components
  DeformationKernel<dim>::gradient_of(const unsigned int q,
                                      const unsigned int i,
                                      const unsigned int d) const
  {
    Components result{};
    for (unsigned int J = 0; J < dim; ++J)
      result[d * dim + J] = values->shape_grad(i, q)[J];
    if (n_components > dim * dim && d == 0)
      result[dim * dim] = values->shape_value(i, q) / values->quadrature_point(q)[0];
    return result;
  }



  template <int dim>
  typename DeformationKernel<dim>::Tangent
  DeformationKernel<dim>::derivative(const Tensor<2, 3> &F, const HyperelasticState &state) const
  {
    const auto place = [](const unsigned int component) {
      return component < dim * dim ?
               std::pair<unsigned int, unsigned int>(component / dim, component % dim) :
               std::pair<unsigned int, unsigned int>(2, 2);
    };
    Tangent result{};
    for (unsigned int m = 0; m < n_components; ++m)
      for (unsigned int n = 0; n <= m; ++n)
        {
          const auto [a, J] = place(m);
          const auto [b, L] = place(n);
          double value      = a == b ? state.stress[J][L] : 0.;
          for (unsigned int I = 0; I < 3; ++I)
            if (F[a][I] != 0)
              for (unsigned int K = 0; K < 3; ++K)
                value += F[a][I] * state.tangent[I][J][K][L] * F[b][K];
          result[m][n] = result[n][m] = value;
        }
    return result;
  }



  template <int dim>
  bool
  DeformationKernel<dim>::assemble(const Cell           &cell,
                                   const Hyperelastic   &law,
                                   const Vector<double> &u,
                                   Vector<double>       &forces,
                                   FullMatrix<double>   *tangent)
  {
    reinit(cell);
    const unsigned int n = dofs->size();
    forces.reinit(n);
    if (tangent)
      {
        tangent->reinit(n, n);
        stressed.reinit(n, n_components, true);
      }
    for (const unsigned int q : values->quadrature_point_indices())
      {
        Tensor<2, 3> F = gradient(q, u);
        if (!(determinant(F) > 0))
          return false;
        HyperelasticState state;
        try
          {
            state = hyperelastic_state(model, law, F);
          }
        catch (const std::domain_error &) // a sheet without a thickness
          {
            return false;
          }
        const Tensor<2, 3> P      = F * Tensor<2, 3>(state.stress);
        const double       weight = values->JxW(q) * measure(model, values->quadrature_point(q));
        const Tangent      D      = tangent ? derivative(F, state) : Tangent{};
        for (unsigned int i = 0; i < n; ++i)
          {
            const unsigned int d = i % dim;
            const Components   G = gradient_of(q, i / dim, d);
            double             f = n_components > dim * dim ? G[dim * dim] * P[2][2] : 0.;
            for (unsigned int J = 0; J < dim; ++J)
              f += G[d * dim + J] * P[d][J];
            forces((*dofs)[i]) += weight * f;
            if (!tangent)
              continue;
            for (unsigned int m = 0; m < n_components; ++m)
              {
                double value = n_components > dim * dim ? G[dim * dim] * D[dim * dim][m] : 0.;
                for (unsigned int J = 0; J < dim; ++J)
                  value += G[d * dim + J] * D[d * dim + J][m];
                stressed(i, m) = weight * value;
              }
            for (unsigned int j = 0; j <= i; ++j)
              {
                const unsigned int e     = j % dim;
                const auto        &grad  = values->shape_grad(j / dim, q);
                double             value = 0;
                for (unsigned int L = 0; L < dim; ++L)
                  value += stressed(i, e * dim + L) * grad[L];
                if (n_components > dim * dim && e == 0)
                  value += stressed(i, dim * dim) * values->shape_value(j / dim, q) /
                           values->quadrature_point(q)[0];
                (*tangent)((*dofs)[i], (*dofs)[j]) += value;
              }
          }
      }
    if (tangent)
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < i; ++j)
          (*tangent)((*dofs)[j], (*dofs)[i]) = (*tangent)((*dofs)[i], (*dofs)[j]);
    return true;
  }



  template <int dim>
  const std::vector<double> &
  DeformationKernel<dim>::volume_ratios(const Cell &cell, const Vector<double> &u)
  {
    reinit(cell);
    ratios.clear();
    for (const unsigned int q : values->quadrature_point_indices())
      ratios.push_back(determinant(gradient(q, u)));
    return ratios;
  }



  template class DeformationKernel<2>;
  template class DeformationKernel<3>;
} // namespace Signorini
