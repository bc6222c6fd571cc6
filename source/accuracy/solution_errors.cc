// SPDX-License-Identifier: Apache-2.0
#include "accuracy/solution_errors.h"

#include "fields/nodal_fields.h"
#include "fields/point_values.h"
#include "fields/recovered_pressure.h"
#include "solid/cell_displacement.h"
#include "solid/scalar_elements.h"
#include "solid/stress.h"
#include <signorini/solid/model.h>

#include <deal.II/hp/fe_values.h>

#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Integrals, over this rank's part, of the square of a deviation and of the square of the
    /// exact field.
    struct Squares
    {
      double error = 0, exact = 0;

      /// Add one quadrature point.
      void
      add(const double weight, const double error2, const double exact2)
      {
        error += weight * error2;
        exact += weight * exact2;
      }

      /// @return the L2 norm of the deviation, relative to that of the exact field unless that is
      /// zero. Collective.
      double
      relative(const MPI_Comm comm) const
      {
        const double e = Utilities::MPI::sum(error, comm), u = Utilities::MPI::sum(exact, comm);
        return u > 0 ? std::sqrt(e / u) : std::sqrt(e);
      }
    };

    /// @return the gradient [component][direction] of a formula by central differences of fourth
    /// order with a step of 1e-4 of the cell, where rounding and truncation are both far below what
    /// a mesh resolves.
    template <int dim>
    Tensor<2, dim>
    gradient(const VectorExpression<dim> &u, const Point<dim> &x, const double t, const double size)
    {
      const double   step = 1e-4 * size;
      Tensor<2, dim> result; // [component][direction]
      for (unsigned int d = 0; d < dim; ++d)
        {
          const Tensor<1, dim> e          = step * Point<dim>::unit_vector(d);
          const Tensor<1, dim> derivative = (8. * (u.value(x + e, t) - u.value(x - e, t)) -
                                             (u.value(x + 2. * e, t) - u.value(x - 2. * e, t))) /
                                            (12 * step);
          for (unsigned int c = 0; c < dim; ++c)
            result[c][d] = derivative[c];
        }
      return result;
    }

    /// Add the errors of the displacement in L2 and in the energy norm. Collective.
    template <int dim>
    void
    add_displacement_errors(const Snapshot<dim>         &s,
                            const VectorExpression<dim> &exact,
                            SolutionErrors              &errors)
    {
      const Elasticity<dim> &elasticity = s.elasticity;
      const LA::Vector       ghosted    = elasticity.with_ghosts(s.displacement);
      CellDisplacement<dim>  at(elasticity, ghosted, gauss_rules(elasticity.finite_elements(), 3));
      Squares                l2, energy;
      for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
        if (cell->is_locally_owned())
          {
            const Material      &material = elasticity.material(cell->material_id());
            const FEValues<dim> &values   = at.reinit(cell);
            for (const unsigned int q : values.quadrature_point_indices())
              {
                // Deviation and exact field at the point, in L2 and in energy.
                const Point<dim>    &x      = values.quadrature_point(q);
                const Tensor<1, dim> wanted = exact.value(x, s.time);
                const Tensor<2, dim> grad   = gradient(exact, x, s.time, cell->diameter());
                const double         weight = values.JxW(q) * measure(elasticity.model(), x);
                const auto density = [&](const Tensor<2, dim> &gradient, const Tensor<1, dim> &v) {
                  const auto eps = strain(elasticity.model(), material, gradient, v, x);
                  return stress(material, eps) * eps;
                };
                l2.add(weight, (at.u[q] - wanted).norm_square(), wanted.norm_square());
                energy.add(weight,
                           density(at.gradient[q] - grad, at.u[q] - wanted),
                           density(grad, wanted));
              }
          }
      errors.displacement = l2.relative(elasticity.mesh().communicator());
      errors.energy       = energy.relative(elasticity.mesh().communicator());
    }

    /// Add the L2 error of the volumetric stress over the bodies in displacement-pressure form.
    /// Collective.
    template <int dim>
    void
    add_volumetric_errors(const Snapshot<dim>   &s,
                          const Expression<dim> &exact,
                          SolutionErrors        &errors)
    {
      const Mesh<dim>  &mesh     = s.elasticity.mesh();
      const auto       &elements = s.elasticity.finite_elements();
      hp::FEValues<dim> all_values(mesh.mappings(),
                                   elements,
                                   gauss_rules(elements, 3),
                                   update_quadrature_points | update_JxW_values);
      Squares           l2;
      for (const auto &cell : s.elasticity.dof_handler().active_cell_iterators())
        if (cell->is_locally_owned() && s.elasticity.volumetric_stress().is_on(*cell))
          {
            all_values.reinit(cell);
            const FEValues<dim> &values = all_values.get_present_fe_values();
            for (const unsigned int q : values.quadrature_point_indices())
              {
                const Point<dim> &x      = values.quadrature_point(q);
                const double      wanted = exact.value(x, s.time),
                             error = s.elasticity.volumetric_stress().value(*cell, x) - wanted;
                l2.add(values.JxW(q) * measure(s.elasticity.model(), x),
                       error * error,
                       wanted * wanted);
              }
          }
      errors.volumetric_stress = l2.relative(mesh.communicator());
    }

    /// Add the L2 errors of the pressure at contact points and of the recovered nodal pressure,
    /// over all contact points. Collective.
    template <int dim>
    void
    add_pressure_errors(const Snapshot<dim>   &s,
                        const Expression<dim> &exact,
                        SolutionErrors        &errors)
    {
      Squares at_points, recovered;
      for (unsigned int pair = 0; pair < s.pairs.size(); ++pair)
        {
          const std::vector<double>  pressure = point_values(s, pair).pressure;
          const LA::Vector           nodal = s.elasticity.with_ghosts(recovered_pressure(s, pair));
          const ContactSurface<dim> &surface = s.surfaces[pair];
          auto                       own     = pressure.begin();
          for (const ContactPoint<dim> &point : surface.points)
            {
              const double wanted = exact.value(point.position, s.time);
              at_points.add(point.weight, std::pow(*own++ - wanted, 2), wanted * wanted);
              recovered.add(point.weight,
                            std::pow(value_at(surface, point, nodal) - wanted, 2),
                            wanted * wanted);
            }
        }
      errors.pressure           = at_points.relative(s.elasticity.mesh().communicator());
      errors.recovered_pressure = recovered.relative(s.elasticity.mesh().communicator());
    }
  } // namespace



  template <int dim>
  SolutionErrors
  errors(const Snapshot<dim> &snapshot, const KnownSolution<dim> &exact)
  {
    SolutionErrors result;
    if (!exact.displacement.empty())
      add_displacement_errors(snapshot, exact.displacement, result);
    if (!exact.volumetric_stress.empty())
      add_volumetric_errors(snapshot, Expression<dim>(exact.volumetric_stress), result);
    if (!exact.pressure.empty())
      add_pressure_errors(snapshot, Expression<dim>(exact.pressure), result);
    return result;
  }



  template SolutionErrors
  errors(const Snapshot<2> &, const KnownSolution<2> &);
  template SolutionErrors
  errors(const Snapshot<3> &, const KnownSolution<3> &);
} // namespace Signorini
