// SPDX-License-Identifier: Apache-2.0
#include "solid/deformation_change.h"

#include "solid/cell_displacement.h"
#include "solid/deformation.h"
#include "solid/scalar_elements.h"

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Densities of work at a point [force/area], or their integrals; NaN where the law has no
    /// stress.
    struct Work
    {
      double of_small = 0; ///< |sigma : Grad u|
      double change   = 0; ///< |(P - sigma) : Grad u|
    };

    /// The integrands of doc/theory, (6.21) at a point: |sigma : Grad u| at small strain, and |(P -
    /// sigma) : Grad u| with P of the hyperelastic law at the same displacement gradient.
    template <int dim>
    Work
    work_at(const Elasticity<dim>   &elasticity,
            const ConstitutiveLaw   &law,
            const CellAccessor<dim> &cell,
            const Tensor<2, dim>    &gradient,
            const Tensor<1, dim>    &u,
            const Point<dim>        &x)
    {
      // In plane stress the response changes F_zz, so that H is formed before.
      Tensor<2, 3>       F = deformation_gradient(elasticity.model(), gradient, u, x);
      const Tensor<2, 3> H = F - Tensor<2, 3>(unit_symmetric_tensor<3>()),
                         sigma(elasticity.stress(cell, gradient, u, x));
      // Laws with internal variables are compared as they are at the start.
      const std::vector<double> internal(law.n_internal(), 0.);
      const auto                state = response_if_any(elasticity.model(),
                                         {law,
                                                         elasticity.volumetric_stress().value(cell, x),
                                                         internal.data(),
                                                         elasticity.thermal().temperature_change(cell, x)},
                                         F);
      return {std::abs(scalar_product(sigma, H)),
              state ? std::abs(scalar_product(F * Tensor<2, 3>(state->stress) - sigma, H)) :
                      std::nan("")};
    }
  } // namespace



  template <int dim>
  DeformationChange
  deformation_change(const Elasticity<dim>                                     &elasticity,
                     const std::vector<std::shared_ptr<const ConstitutiveLaw>> &laws,
                     const LA::Vector                                          &u)
  {
    const Mesh<dim>      &mesh    = elasticity.mesh();
    const LA::Vector      ghosted = elasticity.with_ghosts(u);
    CellDisplacement<dim> at(elasticity, ghosted, gauss_rules(elasticity.finite_elements(), 1));
    DeformationChange     change;
    Work                  sum;
    for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const FEValues<dim> &fe = at.reinit(cell);
          for (const unsigned int q : fe.quadrature_point_indices())
            {
              const Point<dim> &x      = fe.quadrature_point(q);
              const double      weight = fe.JxW(q) * measure(elasticity.model(), x);
              const Work        work =
                work_at(elasticity, *laws[cell->material_id()], *cell, at.gradient[q], at.u[q], x);
              sum.of_small += weight * work.of_small;
              sum.change += weight * work.change;
              // The norm of the antisymmetric part counts its components twice, hence the root of
              // two: in the plane the result is the angle.
              const Tensor<2, dim> strain(symmetrize(at.gradient[q]));
              // The hoop strain u_r/r is no component of the gradient in the plane.
              const double hoop =
                elasticity.model() == Model::axisymmetric ? at.u[q][0] / x[0] : 0.;
              change.strain = std::max(change.strain, std::hypot(strain.norm(), hoop));
              change.largest_rotation =
                std::max(change.largest_rotation, (at.gradient[q] - strain).norm() / std::sqrt(2));
            }
        }
    const MPI_Comm comm     = mesh.communicator();
    const double   whole    = Utilities::MPI::sum(sum.of_small, comm),
                 part       = Utilities::MPI::sum(sum.change, comm);
    change.strain           = Utilities::MPI::max(change.strain, comm);
    change.largest_rotation = Utilities::MPI::max(change.largest_rotation, comm);
    // An inverted point gives NaN, for which both comparisons are false: the change counts as
    // complete.
    change.work = part < whole ? part / whole : part == 0 ? 0. : 1.;
    return change;
  }



#define INSTANTIATE(dim)                                                                           \
  template DeformationChange deformation_change(                                                   \
    const Elasticity<dim> &,                                                                       \
    const std::vector<std::shared_ptr<const ConstitutiveLaw>> &,                                   \
    const LA::Vector &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
