// SPDX-License-Identifier: Apache-2.0
#include "solid/cell_displacement.h"
#include "solid/deformation.h"
#include "solid/scalar_elements.h"
#include "solid/stress.h"
#include "verdict/checks.h"

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The elastic energy of a body, and its spurious volumetric part.
    struct Energies
    {
      double all = 0, locked = 0;
    };

    /// A value at a quadrature point with its weight.
    struct Weighted
    {
      double weight, value;
    };

    /// @return the integral of the squared deviation of values from their mean, or from their best
    /// linear approximation, in a cell (by the normal equations).
    template <int dim>
    double
    rest(const std::vector<Point<dim>> &points,
         const std::vector<Weighted>   &values,
         const bool                     linear)
    {
      const unsigned int n     = linear ? dim + 1 : 1;
      const auto         basis = [&](const unsigned int q, const unsigned int i) {
        return i == 0 ? 1. : points[q][i - 1] - points[0][i - 1];
      };
      // Weighted least squares: what remains of sum w v^2 is the part that is orthogonal to the
      // basis, sum w v^2 - c . r with the solution c of the normal equations. Rounding may make it
      // negative, hence the maximum.
      FullMatrix<double> moments(n);
      Vector<double>     right(n), coefficients(n);
      double             squares = 0;
      for (unsigned int q = 0; q < points.size(); ++q)
        {
          squares += values[q].weight * values[q].value * values[q].value;
          for (unsigned int i = 0; i < n; ++i)
            {
              right(i) += values[q].weight * basis(q, i) * values[q].value;
              for (unsigned int j = 0; j < n; ++j)
                moments(i, j) += values[q].weight * basis(q, i) * basis(q, j);
            }
        }
      moments.gauss_jordan();
      moments.vmult(coefficients, right);
      return std::max(0., squares - coefficients * right);
    }

    /// @return whether a material is compressible enough, or in a form, such that it cannot lock.
    bool
    cannot_lock(const Material &material, const double least_ratio)
    {
      return material.is_up_formulation || material.poissons_ratio < least_ratio;
    }

    /// @return the change of volume: ln J at finite strain, tr(eps) at small strain.
    template <int dim>
    double
    volume_change(const Model           model,
                  const Material       &material,
                  const Tensor<2, dim> &gradient,
                  const Tensor<1, dim> &u,
                  const Point<dim>     &x)
    {
      return material.constitutive_law ?
               std::log(determinant(deformation_gradient(model, gradient, u, x))) :
               trace(strain(model, material, gradient, u, x));
    }

    /// @return at the vertices of simplices (their first degrees of freedom) the means of the
    /// changes of volume in the cells around, weighted with their volumes; with ghost values.
    /// Collective.
    template <int dim>
    LA::Vector
    mean_volume_changes(const Elasticity<dim> &elasticity,
                        const LA::Vector      &ghosted,
                        const double           least_ratio)
    {
      hp::QCollection<dim> vertices;
      for (const auto &fe : elasticity.finite_elements())
        {
          std::vector<Point<dim>> points;
          for (const unsigned int v : fe.reference_cell().vertex_indices())
            points.push_back(fe.reference_cell().template vertex<dim>(v));
          vertices.push_back(Quadrature<dim>(points, std::vector<double>(points.size(), 0.)));
        }
      CellDisplacement<dim> at(elasticity, ghosted, vertices);
      LA::Vector            sum = elasticity.zero_vector(), volume = sum;
      for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
        {
          const Material &material = elasticity.material(cell->material_id());
          if (!cell->is_locally_owned() || !cell->reference_cell().is_simplex() ||
              cannot_lock(material, least_ratio))
            continue;
          const FEValues<dim> &values = at.reinit(cell);
          for (const unsigned int v : cell->vertex_indices())
            {
              const auto   dof    = cell->vertex_dof_index(v, 0, cell->active_fe_index());
              const double change = volume_change(
                elasticity.model(), material, at.gradient[v], at.u[v], values.quadrature_point(v));
              sum(dof) += cell->measure() * change;
              volume(dof) += cell->measure();
            }
        }
      for (LA::Vector *v : {&sum, &volume})
        v->compress(VectorOperation::add);
      for (const auto i : elasticity.owned())
        if (volume(i) > 0)
          sum(i) = sum(i) / volume(i);
      sum.compress(VectorOperation::insert);
      return elasticity.with_ghosts(sum);
    }

    /// @return the energy of each body, and the volumetric energy of the part of the volume change
    /// that a pressure cannot balance without too many constraints. In hypercubes that is what a
    /// pressure of one degree less could not represent: the deviation from the mean for degree 1,
    /// from a linear function for higher degrees. In simplices a pressure of one degree less in
    /// each cell is too many constraints already; there it is the deviation from a continuous
    /// linear function, that of the means at vertices. Collective.
    template <int dim>
    std::vector<Energies>
    energies_of_bodies(const Snapshot<dim> &s, const double least_ratio)
    {
      const Elasticity<dim> &elasticity = s.elasticity;
      const LA::Vector       ghosted    = elasticity.with_ghosts(s.displacement);
      CellDisplacement<dim>  at(elasticity, ghosted, gauss_rules(elasticity.finite_elements(), 1));
      const LA::Vector       means = elasticity.mesh().has_simplices() ?
                                       mean_volume_changes(elasticity, ghosted, least_ratio) :
                                       LA::Vector();
      std::vector<Energies>  energies(elasticity.mesh().n_bodies());
      std::vector<Weighted>  volume;
      for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
        {
          const Material &material = elasticity.material(cell->material_id());
          // Bodies in displacement-pressure form do not lock, and compressible ones hardly.
          if (!cell->is_locally_owned() || cannot_lock(material, least_ratio))
            continue;
          const FEValues<dim> &values = at.reinit(cell);
          volume.resize(values.n_quadrature_points);
          Energies &of_body = energies[elasticity.mesh().body(cell)];
          for (unsigned int q = 0; q < volume.size(); ++q)
            {
              const Point<dim> &x      = values.quadrature_point(q);
              const double      weight = values.JxW(q) * measure(elasticity.model(), x);
              volume[q]                = {weight,
                                          volume_change(elasticity.model(), material, at.gradient[q], at.u[q], x)};
              // At finite strain the energy is that of the law, at small strain half of sigma:eps.
              if (material.constitutive_law)
                {
                  auto F = deformation_gradient(elasticity.model(), at.gradient[q], at.u[q], x);
                  std::vector<double> internal;
                  of_body.all += weight * response_at(elasticity.model(),
                                                      elasticity.material_point(*cell, x, internal),
                                                      F,
                                                      ResponseOrder::stress)
                                            .energy;
                  continue;
                }
              const auto eps = strain(elasticity.model(), material, at.gradient[q], at.u[q], x);
              of_body.all += 0.5 * weight * (stress(material, eps) * eps);
            }
          // The spurious part: lambda/2 times the squared deviation of the volume change.
          double squares = 0;
          if (cell->reference_cell().is_simplex())
            for (unsigned int q = 0; q < volume.size(); ++q)
              {
                double deviation = volume[q].value;
                for (const unsigned int v : cell->vertex_indices())
                  deviation -=
                    means(cell->vertex_dof_index(v, 0, cell->active_fe_index())) *
                    cell->reference_cell().d_linear_shape_function(values.get_quadrature().point(q),
                                                                   v);
                squares += volume[q].weight * deviation * deviation;
              }
          else
            squares = rest(values.get_quadrature_points(), volume, cell->get_fe().degree > 1);
          of_body.locked += 0.5 * material.lambda() * squares;
        }
      const MPI_Comm comm = elasticity.mesh().communicator();
      for (Energies &of_body : energies)
        for (double *energy : {&of_body.all, &of_body.locked})
          *energy = Utilities::MPI::sum(*energy, comm);
      return energies;
    }
  } // namespace



  // The body with the largest share is reported. In plane stress bodies can change their thickness
  // and do not lock.
  template <int dim>
  std::vector<CheckResult>
  check_locking(const Snapshot<dim> &now)
  {
    constexpr double least_ratio = 0.4; // below there is little to lock
    if (now.elasticity.model() == Model::plane_stress)
      return {};
    CheckResult check_result;
    check_result.check  = "volumetric locking";
    check_result.limit  = 0.01;
    const auto energies = energies_of_bodies(now, least_ratio);
    // The share of the spurious energy in all strain energy of each body.
    for (unsigned int body = 0; body < energies.size(); ++body)
      {
        const Energies &of_body = energies[body];
        const double    share   = of_body.all > 0 ? of_body.locked / of_body.all : 0.;
        // The name of the body is kept in `message` until the sentence is composed.
        if (share >= check_result.value)
          {
            check_result.value   = share;
            check_result.message = now.elasticity.mesh().body_name(body);
          }
      }
    check_result.outcome =
      check_result.value > check_result.limit ? Outcome::warned : Outcome::passed;
    check_result.message =
      "'" + check_result.message +
      "' is nearly incompressible and locks on this mesh: that fraction of its energy is spurious volumetric "
      "energy within cells. The relative error of forces is about that value (on triangles and tetrahedra up to three "
      "times that), that of pressures three times as large";
    check_result.advice = "set Formulation = mixed with Degree = 2, or use a finer mesh";
    return {check_result};
  }



  template std::vector<CheckResult>
  check_locking(const Snapshot<2> &);
  template std::vector<CheckResult>
  check_locking(const Snapshot<3> &);
} // namespace Signorini
