#include <signorini/elasticity/deformation.h>
#include <signorini/elasticity/deformation_change.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/hp/fe_values.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    constexpr double folded = -1; // instead of a share

    /// (P - sigma) : Grad u at one point, relative to nothing; not a number where there is no P.
    template <int dim>
    double
    excess(const Model                  model,
           const Hyperelastic          &law,
           const Tensor<2, dim>        &gradient,
           const Tensor<1, dim>        &u,
           const Point<dim>            &x,
           const SymmetricTensor<2, 3> &sigma,
           const double                 bulk_stress)
    {
      Tensor<2, 3> F = deformation_gradient(model, gradient, u, x);
      if (!(determinant(F) > 0))
        return std::nan("");
      const Tensor<2, 3> H = F - Tensor<2, 3>(unit_symmetric_tensor<3>());
      try
        {
          const SymmetricTensor<2, 3> S = hyperelastic_state(model, law, F, bulk_stress).stress;
          return scalar_product(F * Tensor<2, 3>(S) - Tensor<2, 3>(sigma), H);
        }
      catch (const std::domain_error &)
        {
          return std::nan("");
        }
    }
  } // namespace



  template <int dim>
  DeformationChange
  deformation_change(const Elasticity<dim>                                  &elasticity,
                     const std::vector<std::shared_ptr<const Hyperelastic>> &laws,
                     const LA::Vector                                       &u)
  {
    const Mesh<dim>     &mesh    = elasticity.mesh();
    const LA::Vector     ghosted = elasticity.with_ghosts(u);
    hp::QCollection<dim> rules;
    for (unsigned int i = 0; i < elasticity.finite_elements().size(); ++i)
      rules.push_back(QGauss<dim>(elasticity.finite_elements()[i].degree + 1));
    hp::FEValues<dim>                all_values(mesh.mappings(),
                                 elasticity.finite_elements(),
                                 rules,
                                 update_values | update_gradients | update_quadrature_points |
                                   update_JxW_values);
    const FEValuesExtractors::Vector displacement(0);
    std::vector<Tensor<1, dim>>      values;
    std::vector<Tensor<2, dim>>      gradients;
    DeformationChange                change;
    double                           whole = 0, neglected = 0;
    bool                             is_folded = false;
    for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          all_values.reinit(cell);
          const FEValues<dim> &fe = all_values.get_present_fe_values();
          values.resize(fe.n_quadrature_points);
          gradients.resize(fe.n_quadrature_points);
          fe[displacement].get_function_values(ghosted, values);
          fe[displacement].get_function_gradients(ghosted, gradients);
          for (const unsigned int q : fe.quadrature_point_indices())
            {
              const Point<dim>           &x = fe.quadrature_point(q);
              const SymmetricTensor<2, 3> sigma =
                elasticity.stress(*cell, gradients[q], values[q], x);
              const SymmetricTensor<2, dim> strain = symmetrize(gradients[q]);
              const double                  weight = fe.JxW(q) * measure(elasticity.model(), x);
              const Tensor<2, 3>            F =
                deformation_gradient(elasticity.model(), gradients[q], values[q], x);
              whole += std::abs(scalar_product(Tensor<2, 3>(sigma),
                                               F - Tensor<2, 3>(unit_symmetric_tensor<3>()))) *
                       weight;
              const double more = excess(elasticity.model(),
                                         *laws[cell->material_id()],
                                         gradients[q],
                                         values[q],
                                         x,
                                         sigma,
                                         elasticity.bulk_stress().value(*cell, x));
              is_folded |= std::isnan(more);
              neglected += std::abs(more) * weight;
              change.strain = std::max(change.strain, strain.norm());
              change.turn   = std::max(change.turn,
                                     (gradients[q] - Tensor<2, dim>(strain)).norm() / std::sqrt(2));
            }
        }
    const MPI_Comm comm = mesh.communicator();
    whole               = Utilities::MPI::sum(whole, comm);
    neglected           = Utilities::MPI::sum(std::isnan(neglected) ? 0 : neglected, comm);
    change.strain       = Utilities::MPI::max(change.strain, comm);
    change.turn         = Utilities::MPI::max(change.turn, comm);
    change.work         = Utilities::MPI::max(is_folded ? 1 : 0, comm) > 0 ? 1. :
                          whole > 0 ? std::min(1., neglected / whole) :
                                      0.;
    return change;
  }



#define INSTANTIATE(dim)                                                                           \
  template DeformationChange deformation_change(                                                   \
    const Elasticity<dim> &,                                                                       \
    const std::vector<std::shared_ptr<const Hyperelastic>> &,                                      \
    const LA::Vector &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
