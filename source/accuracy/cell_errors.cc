// SPDX-License-Identifier: Apache-2.0
#include "accuracy/error_parts.h"
#include "accuracy/recovered_field.h"
#include "solid/stress.h"
#include "solid/stress_state.h"
#include <signorini/solid/model.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    using CellOf = typename DoFHandler<dim>::active_cell_iterator;

    /// Displacements and their gradients at the points of a cell, of one field after the other.
    template <int dim>
    class FieldValues
    {
    public:
      /// @param fields with ghost values
      explicit FieldValues(const std::vector<DualField> &fields)
        : fields(fields)
      {}

      void
      read(const FEValues<dim> &at, const unsigned int field)
      {
        const FEValuesExtractors::Vector v(0);
        u.resize(at.n_quadrature_points);
        gradient.resize(at.n_quadrature_points);
        at[v].get_function_values(fields[field].displacement, u);
        at[v].get_function_gradients(fields[field].displacement, gradient);
      }

      const std::vector<DualField> &fields;
      std::vector<Tensor<1, dim>>   u;
      std::vector<Tensor<2, dim>>   gradient;
    };

    /// The densities of CellErrors at a point.
    struct PointErrors
    {
      double              energy = 0, energy_of_solution = 0;
      std::vector<double> products, energies_of_duals; ///< by dual field
    };

    /// The errors by bodies of linear elasticity in displacement form, (8.6): stress and strain of
    /// all fields determine each other, so that the stress alone is recovered.
    template <int dim>
    class LinearErrors
    {
    public:
      static constexpr unsigned int n_components = dim == 2 ? 4 : 6; // plane stresses have four

      LinearErrors(const Elasticity<dim> &elasticity, const std::vector<DualField> &fields)
        : elasticity(elasticity)
        , values(fields)
      {}

      unsigned int
      n_values() const
      {
        // The last value is the error of the temperature.
        return n_components * values.fields.size() + 1;
      }

      // Displacements are needed for the hoop strain of axisymmetric models only. Only the solution
      // has thermal strain, since dual solutions are changes of displacement.
      void
      sample(const CellOf<dim> &cell, const FEValues<dim> &at, double *const result)
      {
        const Material &material = elasticity.material(cell->material_id());
        for (unsigned int f = 0; f < values.fields.size(); ++f)
          {
            values.read(at, f);
            for (const unsigned int q : at.quadrature_point_indices())
              {
                const Point<dim> &x = at.quadrature_point(q);
                const auto        sigma =
                  f == 0 ?
                           elasticity.stress(*cell, values.gradient[q], values.u[q], x) :
                           stress(
                      material,
                      strain(elasticity.model(), material, values.gradient[q], values.u[q], x));
                for (unsigned int c = 0; c < n_components; ++c)
                  result[q * n_values() + f * n_components + c] = sigma.access_raw_entry(c);
              }
          }
        for (const unsigned int q : at.quadrature_point_indices())
          result[(q + 1) * n_values() - 1] = elasticity.thermal().projection_error(at, q);
      }

      // Energy products of stresses: (s, t) = s : C^-1 t, with the compliance C^-1 of the material.
      // The temperature that elements cannot follow works with the whole dual stress, (8.24).
      void
      at_point(const CellOf<dim>  &cell,
               const double *const computed,
               const double *const deviation,
               PointErrors        &result)
      {
        const Material &material = elasticity.material(cell->material_id());
        const auto      tensor   = [](const double *const from, const unsigned int field) {
          SymmetricTensor<2, 3> result;
          for (unsigned int c = 0; c < n_components; ++c)
            result.access_raw_entry(c) = from[field * n_components + c];
          return result;
        };
        const auto of_solution = tensor(deviation, 0), sigma = tensor(computed, 0);
        const auto strain         = compliance(material, of_solution);
        result.energy             = of_solution * strain;
        result.energy_of_solution = sigma * compliance(material, sigma);
        for (unsigned int z = 1; z < values.fields.size(); ++z)
          {
            const auto of_dual              = tensor(deviation, z);
            result.products[z - 1]          = of_dual * strain;
            result.energies_of_duals[z - 1] = of_dual * compliance(material, of_dual);
            if (const double rise = computed[n_values() - 1]; rise != 0)
              {
                const Tensor<1, 3> alpha = elasticity.thermal().alpha(cell->material_id());
                const auto         whole = tensor(computed, z) + of_dual;
                for (unsigned int d = 0; d < 3; ++d)
                  result.products[z - 1] += rise * alpha[d] * whole[d][d];
              }
          }
      }

    private:
      const Elasticity<dim> &elasticity;
      FieldValues<dim>       values;
    };

    /// The errors by bodies of any law, (8.20): stress, gradient and volumetric stress of each
    /// field are recovered, the stress of a dual field by the linearisation at the solution.
    template <int dim>
    class NonlinearErrors
    {
    public:
      NonlinearErrors(const Elasticity<dim> &elasticity, const std::vector<DualField> &fields)
        : elasticity(elasticity)
        , values(fields)
        , is_mixed(!elasticity.volumetric_stress().empty())
        , per_field(2 * n_components + (is_mixed ? 2 : 0))
      {}

      unsigned int
      n_values() const
      {
        // Of each field, in this order: stress, gradient, volumetric stress and residual of the
        // volume. The last values are the error of the temperature and the energy of the solution.
        return per_field * values.fields.size() + 2;
      }

      // The states of stress at the points are those of the solution, about which the dual fields
      // are linearised; hence the loop over points inside of that over fields.
      void
      sample(const CellOf<dim> &cell, const FEValues<dim> &at, double *const result)
      {
        const Model              model = elasticity.model();
        std::vector<StressState> states;
        for (unsigned int f = 0; f < values.fields.size(); ++f)
          {
            values.read(at, f);
            for (const unsigned int q : at.quadrature_point_indices())
              {
                const Point<dim> &x  = at.quadrature_point(q);
                double *const     to = result + q * n_values() + f * per_field;
                const auto        G = gradient_of_change(model, values.gradient[q], values.u[q], x);
                write(G, to + n_components);
                if (f == 0)
                  {
                    states.push_back(
                      stress_state(elasticity, *cell, values.gradient[q], values.u[q], x));
                    write(states[q].stress, to);
                    result[(q + 1) * n_values() - 2] = elasticity.thermal().projection_error(at, q);
                    result[(q + 1) * n_values() - 1] = states[q].energy;
                    if (is_mixed)
                      write(elasticity.volumetric_stress().value(*cell, x),
                            states[q].volume_residual,
                            to);
                    continue;
                  }
                const double m = is_mixed ? elasticity.volumetric_stress().value(
                                              *cell, x, values.fields[f].volumetric_stress) :
                                            0.;
                write(states[q].change_of_stress(G, m), to);
                if (is_mixed)
                  write(m, states[q].change_of_volume_residual(G, m), to);
              }
          }
      }

      // For the solution itself and for a dual field the second variation of the energy between
      // errors.
      void
      at_point(const CellOf<dim>  &cell,
               const double *const computed,
               const double *const deviation,
               PointErrors        &result)
      {
        result.energy             = std::max(0., product(computed, deviation, 0, 0));
        result.energy_of_solution = 2 * computed[n_values() - 1];
        for (unsigned int z = 1; z < values.fields.size(); ++z)
          {
            result.products[z - 1] =
              (product(computed, deviation, 0, z) + product(computed, deviation, z, 0)) / 2;
            result.energies_of_duals[z - 1] = std::max(0., product(computed, deviation, z, z));
            if (const double rise = computed[n_values() - 2]; rise != 0)
              result.products[z - 1] +=
                rise * of_unit_rise(elasticity.thermal().alpha(cell->material_id()),
                                    computed,
                                    deviation,
                                    z);
          }
      }

    private:
      /// Components of gradients: those in the plane or in space, and the one across the plane.
      static constexpr unsigned int n_components = dim == 2 ? 5 : 9;

      static void
      write(const Tensor<2, 3> &tensor, double *const to)
      {
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int j = 0; j < dim; ++j)
            to[i * dim + j] = tensor[i][j];
        if (dim == 2)
          to[n_components - 1] = tensor[2][2];
      }

      void
      write(const double volumetric_stress, const double volume_residual, double *const to) const
      {
        to[per_field - 2] = volumetric_stress;
        to[per_field - 1] = volume_residual;
      }

      /// Second variation of the energy between two fields, as far as it is known from one of them:
      /// @return the residual of field `one`, weighted with the error of field `other`: the
      /// deviation of its stress times that of the gradient, and the residual of its volume, which
      /// is zero for the exact field, times the deviation of the volumetric stress.
      double
      product(const double *const computed,
              const double *const deviation,
              const unsigned int  one,
              const unsigned int  other) const
      {
        const double *const of_one = deviation + one * per_field, *const of_other =
                                                                    deviation + other * per_field;
        double sum = 0;
        for (unsigned int c = 0; c < n_components; ++c)
          sum += of_one[c] * of_other[n_components + c];
        if (is_mixed)
          sum -= computed[(one + 1) * per_field - 1] * of_other[per_field - 2];
        return sum;
      }

      /// @return the work of the dual stress with the thermal strain of a temperature of one, F
      /// diag(alpha), (8.24).
      double
      of_unit_rise(const Tensor<1, 3> &alpha,
                   const double *const computed,
                   const double *const deviation,
                   const unsigned int  dual) const
      {
        double sum = 0;
        for (unsigned int c = 0; c < n_components; ++c)
          {
            const bool         is_across = dim == 2 && c == n_components - 1;
            const unsigned int i = is_across ? 2 : c / dim, j = is_across ? 2 : c % dim;
            const double       F      = computed[n_components + c] + (i == j ? 1 : 0);
            const unsigned int stress = dual * per_field + c;
            sum += (computed[stress] + deviation[stress]) * F * alpha[j];
          }
        return sum;
      }

      const Elasticity<dim> &elasticity;
      FieldValues<dim>       values;
      const bool             is_mixed;
      const unsigned int     per_field;
    };

    /// The share of the energy of a cell of degree 1 that may be missed, where the stress across
    /// the cell is not recovered from other cells, as it is one layer: a bilinear cell does not
    /// contract across as it should, and is too stiff by nu^2/(1 - nu^2) at least; a layer between
    /// stiff bodies does not bulge at its edges at all.
    constexpr double share_of_layer = 0.3;
    /// The same for degree 2, of what varies within the cell: parabolas of shear are unknown to it.
    constexpr double share_of_quadratic_layer = 0.02;

    /// The energy of the solution and those of dual fields in a cell.
    /// @param is_whole with that of the mean stress; otherwise of what varies within the cell
    template <typename Errors, typename Cell, typename Recovered>
    PointErrors
    energies_in_layer(Errors            &errors,
                      const Cell        &cell,
                      const Recovered   &at,
                      const unsigned int n_duals,
                      const bool         is_whole)
    {
      const unsigned int  n = errors.n_values();
      std::vector<double> mean(n, 0.), deviation(n);
      double              volume = 0;
      for (unsigned int q = 0; q < at.weights.size() && !is_whole; ++q)
        {
          volume += at.weights[q];
          for (unsigned int c = 0; c < n; ++c)
            mean[c] += at.weights[q] * at.computed[q * n + c];
        }
      for (unsigned int c = 0; c < n && volume > 0; ++c)
        mean[c] /= volume;
      PointErrors sum{0, 0, std::vector<double>(n_duals), std::vector<double>(n_duals)},
        there = sum;
      for (unsigned int q = 0; q < at.weights.size(); ++q)
        {
          for (unsigned int c = 0; c < n; ++c)
            deviation[c] = at.computed[q * n + c] - mean[c];
          errors.at_point(cell, &at.computed[q * n], deviation.data(), there);
          sum.energy += at.weights[q] * there.energy;
          for (unsigned int z = 0; z < n_duals; ++z)
            sum.energies_of_duals[z] += at.weights[q] * there.energies_of_duals[z];
        }
      return sum;
    }

    /// Integrate the errors of all points. The kind of errors is a template, since it is called at
    /// each point.
    template <int dim, typename Errors>
    CellErrors
    integrate(const Elasticity<dim> &elasticity, const std::vector<DualField> &fields)
    {
      Errors              errors(elasticity, fields);
      RecoveredField<dim> recovered(elasticity,
                                    errors.n_values(),
                                    [&](const auto &cell, const auto &at, double *const values) {
                                      errors.sample(cell, at, values);
                                    });
      const auto         &triangulation = elasticity.mesh().triangulation();
      const unsigned int  n = triangulation.n_active_cells(), n_duals = fields.size() - 1;
      CellErrors          result;
      result.energy.assign(n, 0.);
      result.products.assign(n_duals, std::vector<double>(n, 0.));
      result.layers = result.products;
      result.cauchy_schwarz_bounds.assign(n_duals, 0.);
      std::vector<double> energies_of_cell(n_duals);
      PointErrors         there{0, 0, std::vector<double>(n_duals), std::vector<double>(n_duals)};
      double              energy = 0;
      for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
        if (cell->is_locally_owned())
          {
            const auto        &at = recovered(cell);
            const unsigned int i  = cell->active_cell_index();
            energies_of_cell.assign(n_duals, 0.);
            for (unsigned int q = 0; q < at.weights.size(); ++q)
              {
                errors.at_point(cell,
                                &at.computed[q * errors.n_values()],
                                &at.deviation[q * errors.n_values()],
                                there);
                result.energy[i] += at.weights[q] * there.energy;
                for (unsigned int z = 0; z < n_duals; ++z)
                  {
                    result.products[z][i] += at.weights[q] * there.products[z];
                    energies_of_cell[z] += at.weights[q] * there.energies_of_duals[z];
                  }
                energy += at.weights[q] * there.energy_of_solution;
              }
            for (unsigned int z = 0; z < n_duals; ++z)
              result.cauchy_schwarz_bounds[z] += std::sqrt(result.energy[i] * energies_of_cell[z]);
            if (n_duals > 0 && is_one_cell_thick<dim>(cell))
              {
                const bool        is_linear = elasticity.degree(elasticity.mesh().body(cell)) == 1;
                const PointErrors within = energies_in_layer(errors, cell, at, n_duals, is_linear);
                for (unsigned int z = 0; z < n_duals; ++z)
                  result.layers[z][i] = (is_linear ? share_of_layer : share_of_quadratic_layer) *
                                        std::sqrt(within.energy * within.energies_of_duals[z]);
              }
          }
      Utilities::MPI::sum(result.cauchy_schwarz_bounds,
                          triangulation.get_communicator(),
                          result.cauchy_schwarz_bounds);
      result.energy_of_solution = Utilities::MPI::sum(energy, triangulation.get_communicator());
      return result;
    }
  } // namespace



  template <int dim>
  DualField
  with_ghosts(const Elasticity<dim> &elasticity, const DualField &dual)
  {
    DualField result = {elasticity.with_ghosts(dual.displacement), {}};
    if (dual.volumetric_stress.size() > 0)
      result.volumetric_stress = elasticity.volumetric_stress().with_ghosts(dual.volumetric_stress);
    return result;
  }



  template <int dim>
  CellErrors
  cell_errors(const Elasticity<dim>        &elasticity,
              const LA::Vector             &displacement,
              const std::vector<DualField> &duals)
  {
    std::vector<DualField> fields = {{elasticity.with_ghosts(displacement), {}}};
    for (const DualField &dual : duals)
      fields.push_back(with_ghosts(elasticity, dual));
    return elasticity.is_nonlinear() || !elasticity.volumetric_stress().empty() ?
             integrate<dim, NonlinearErrors<dim>>(elasticity, fields) :
             integrate<dim, LinearErrors<dim>>(elasticity, fields);
  }



  template DualField
  with_ghosts(const Elasticity<2> &, const DualField &);
  template DualField
  with_ghosts(const Elasticity<3> &, const DualField &);
  template CellErrors
  cell_errors(const Elasticity<2> &, const LA::Vector &, const std::vector<DualField> &);
  template CellErrors
  cell_errors(const Elasticity<3> &, const LA::Vector &, const std::vector<DualField> &);
} // namespace Signorini
