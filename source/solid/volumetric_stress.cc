// SPDX-License-Identifier: Apache-2.0
#include "solid/volumetric_stress.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_dgp.h>
#include <deal.II/fe/fe_nothing.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace Signorini
{
  using namespace dealii;

  // If no material is in displacement-pressure form, the lists stay empty, and with them all
  // functions of this class.
  // Two elements: one without functions for bodies in displacement form, and discontinuous linear
  // polynomials, dim + 1 functions a cell, for those in displacement-pressure form.
  template <int dim>
  VolumetricStress<dim>::VolumetricStress(const Mesh<dim>             &mesh,
                                          const std::vector<Material> &materials,
                                          const Model                  model)
    : mesh(mesh)
    , model(model)
    , elements(FE_Nothing<dim>(), FE_DGP<dim>(1))
  {
    if (std::none_of(materials.begin(), materials.end(), [](const Material &material) {
          return material.is_up_formulation;
        }))
      return;
    for (const Material &material : materials)
      {
        mixed.push_back(material.is_up_formulation);
        mu.push_back(material.mu());
      }
  }



  // Make degrees of freedom, bases and the ghosted vector for the present mesh; coefficients are
  // zero.
  template <int dim>
  void
  VolumetricStress<dim>::reinit()
  {
    if (empty())
      return;
    distribute_dofs();
    make_bases();
    IndexSet relevant;
    DoFTools::extract_locally_relevant_dofs(dofs, relevant);
    zero_with_ghosts.reinit(owned(), relevant, mesh.communicator());
  }



  // Cells of other bodies have the element without functions.
  template <int dim>
  void
  VolumetricStress<dim>::distribute_dofs()
  {
    dofs.reinit(mesh.triangulation());
    for (const auto &cell : dofs.active_cell_iterators())
      if (cell->is_locally_owned())
        cell->set_active_fe_index(mixed[cell->material_id()] ? 1 : 0);
    dofs.distribute_dofs(elements);
  }



  // One orthogonal basis for each owned and ghost cell of bodies in this form, evaluated with the
  // quadrature of their stiffness (three points in each direction).
  template <int dim>
  void
  VolumetricStress<dim>::make_bases()
  {
    // The quadrature of the stiffness of these cells.
    FEValues<dim> values(mesh.mapping(),
                         elements[0],
                         QGauss<dim>(3),
                         update_quadrature_points | update_JxW_values);
    of_cells.clear();
    number.assign(mesh.triangulation().n_active_cells(), numbers::invalid_unsigned_int);
    for (const auto &cell : dofs.active_cell_iterators())
      if (!cell->is_artificial() && is_on(*cell))
        {
          number[cell->active_cell_index()] = of_cells.size();
          values.reinit(static_cast<const typename Triangulation<dim>::cell_iterator &>(cell));
          Basis one;
          one.indices.resize(functions_per_cell);
          cell->get_dof_indices(one.indices);
          // The cell size h as the edge of a cube with the same diagonal; functions are of the size
          // mu/h.
          const double h = cell->diameter() / std::sqrt(double(dim));
          orthogonalise(values, mu[cell->material_id()] / h, one);
          of_cells.push_back(one);
        }
  }



  // Gram-Schmidt orthogonalisation of 1 and the coordinates relative to the centroid, with the
  // scalar product of the cell's quadrature (doc/theory, 6.6); then all functions are scaled to the
  // norm unit^2 times the volume, so that mass matrices are diagonal with one value for each cell.
  template <int dim>
  void
  VolumetricStress<dim>::orthogonalise(const FEValues<dim> &values,
                                       const double         unit,
                                       Basis               &one) const
  {
    std::vector<double> weights;
    double              volume = 0;
    Tensor<1, dim>      moment;
    for (const unsigned int q : values.quadrature_point_indices())
      {
        const Point<dim> &x = values.quadrature_point(q);
        weights.push_back(values.JxW(q) * measure(model, x));
        volume += weights.back();
        moment += weights.back() * Tensor<1, dim>(x);
      }
    one.center = Point<dim>(moment / volume);
    one.size   = unit * unit * volume;

    // A row has the coefficients of 1 and of the coordinates relative to the centroid.
    const auto at = [&](const Functions &row, const unsigned int q) {
      double sum = row[0];
      for (unsigned int d = 0; d < dim; ++d)
        sum += row[d + 1] * (values.quadrature_point(q)[d] - one.center[d]);
      return sum;
    };
    const auto product = [&](const Functions &a, const Functions &b) {
      double sum = 0;
      for (const unsigned int q : values.quadrature_point_indices())
        sum += weights[q] * at(a, q) * at(b, q);
      return sum;
    };
    for (unsigned int i = 0; i < functions_per_cell; ++i)
      {
        Functions &row = one.rows[i];
        row.fill(0.);
        row[i] = 1;
        // Earlier functions are orthogonal to each other and all have the same norm, so that their
        // shares can be subtracted one after the other.
        for (unsigned int j = 0; j < i; ++j)
          {
            const double share = product(row, one.rows[j]) / one.size;
            for (unsigned int k = 0; k <= j; ++k)
              row[k] -= share * one.rows[j][k];
          }
        const double factor = std::sqrt(one.size / product(row, row));
        for (double &entry : row)
          entry *= factor;
      }
  }



  // The rows are lower triangular: function i has the coordinates up to i - 1.
  template <int dim>
  typename VolumetricStress<dim>::Functions
  VolumetricStress<dim>::functions(const Cell &cell, const Point<dim> &x) const
  {
    const Basis         &own  = basis(cell);
    const Tensor<1, dim> from = x - own.center;
    Functions            result;
    for (unsigned int i = 0; i < functions_per_cell; ++i)
      {
        result[i] = own.rows[i][0];
        for (unsigned int d = 0; d < i; ++d)
          result[i] += own.rows[i][d + 1] * from[d];
      }
    return result;
  }



  // m = sum_i m_i phi_i at a point of a cell, zero in other bodies.
  template <int dim>
  double
  VolumetricStress<dim>::value(const Cell &cell, const Point<dim> &x) const
  {
    if (!is_on(cell))
      return 0;
    const Functions  phi = functions(cell, x);
    const Functions &m   = coefficients(cell);
    return std::inner_product(m.begin(), m.end(), phi.begin(), 0.);
  }



  // The coefficients of cells that this rank owns as a distributed vector. Collective.
  template <int dim>
  LA::Vector
  VolumetricStress<dim>::coefficients() const
  {
    LA::Vector result = zero_vector(); // nothing where no body is mixed
    if (empty())
      return result;
    for (const Basis &one : of_cells)
      if (owned().is_element(one.indices[0]))
        for (unsigned int i = 0; i < functions_per_cell; ++i)
          result(one.indices[i]) = one.coefficients[i];
    result.compress(VectorOperation::insert);
    return result;
  }



  // Ghost cells get the coefficients of their owners. Collective.
  template <int dim>
  void
  VolumetricStress<dim>::set_coefficients(const LA::Vector &values)
  {
    if (empty())
      return;
    LA::Vector all = zero_with_ghosts;
    all            = values;
    for (Basis &one : of_cells)
      for (unsigned int i = 0; i < functions_per_cell; ++i)
        one.coefficients[i] = all(one.indices[i]);
  }



  template class VolumetricStress<2>;
  template class VolumetricStress<3>;
} // namespace Signorini
