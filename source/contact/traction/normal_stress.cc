// SPDX-License-Identifier: Apache-2.0
#include "contact/traction/normal_stress.h"

#include "geometry/lagrange.h"
#include "solid/cell_nodes.h"
#include "solid/deformation.h"

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// A vector or tensor of the model, extended by zeros to three dimensions.
    template <int rank, int dim>
    Tensor<rank, 3>
    in_space(const Tensor<rank, dim> &v)
    {
      Tensor<rank, 3> result;
      for (unsigned int d = 0; d < dim; ++d)
        if constexpr (rank == 1)
          result[d] = v[d];
        else
          result[d] = in_space(v[d]);
      return result;
    }
  } // namespace



  template <int dim>
  NormalStress<dim>::NormalStress(const Elasticity<dim> &elasticity)
    : elasticity(elasticity)
    , geometry_degree(elasticity.mesh().geometry_degree())
    , kernel(elasticity.mesh(), elasticity.finite_elements(), elasticity.model())
  {
    if (elasticity.mesh().has_simplices())
      simplex = std::make_shared<const FE_SimplexP<dim>>(std::min(geometry_degree, 2u));
    // Multi-indices of the nodes of the cell's geometry, lexicographic.
    const unsigned int n = geometry_degree + 1;
    for (unsigned int i = 0; i < Utilities::fixed_power<dim>(n); ++i)
      {
        lattice.emplace_back();
        for (unsigned int d = 0, rest = i; d < dim; ++d, rest /= n)
          lattice.back()[d] = rest % n;
      }
    const hp::FECollection<dim> &elements = elasticity.finite_elements();
    lattices.resize(elements.size());
    for (unsigned int e = 0; e < elements.size(); ++e)
      if (const FiniteElement<dim> &fe = elements[e].base_element(0);
          fe.reference_cell().is_hyper_cube())
        for (const Point<dim> &p : fe.get_unit_support_points())
          {
            lattices[e].emplace_back();
            for (unsigned int d = 0; d < dim; ++d)
              lattices[e].back()[d] = std::lround(fe.degree * p[d]);
          }
  }



  template <int dim>
  NormalStress<dim>::NormalStress(const Configuration<dim> &configuration)
    : NormalStress(configuration.elasticity())
  {
    // At finite strain stresses are evaluated at the displacement of the configuration.
    if (elasticity.is_finite_strain())
      displacement = elasticity.with_ghosts(
        configuration.is_reference() ? elasticity.zero_vector() : configuration.displacement());
  }



  // Consecutive points are mostly in the same cell, whose nodes and indices are then kept.
  template <int dim>
  void
  NormalStress<dim>::reinit(const Cell &new_cell)
  {
    if (cell.state() == IteratorState::valid && cell == new_cell)
      return;
    cell = new_cell;
    read_indices<dim>(cell, indices);
    nodes.clear();
    const Mapping<dim> &mapping = elasticity.mesh().mapping();
    if (cell->reference_cell().is_simplex())
      {
        for (const Point<dim> &p : simplex->get_unit_support_points())
          nodes.push_back(mapping.transform_unit_to_real_cell(cell, p));
        return;
      }
    for (const auto &unit_x : lattice)
      {
        Point<dim> p;
        for (unsigned int d = 0; d < dim; ++d)
          p[d] = double(unit_x[d]) / geometry_degree;
        nodes.push_back(mapping.transform_unit_to_real_cell(cell, p));
      }
  }



  // dx/dxi of the geometry at any point of the reference cell, also on its faces: columns are the
  // derivatives along the reference coordinates.
  template <int dim>
  Tensor<2, dim>
  NormalStress<dim>::jacobian(const Point<dim> &unit_point) const
  {
    Tensor<2, dim> J;
    if (cell->reference_cell().is_simplex())
      {
        for (unsigned int i = 0; i < nodes.size(); ++i)
          J += outer_product(Tensor<1, dim>(nodes[i]), simplex->shape_grad(i, unit_point));
        return J;
      }
    const LagrangePolynomials<dim> basis(geometry_degree, unit_point);
    auto                           node = nodes.begin();
    for (const auto &unit_x : lattice)
      J += outer_product(Tensor<1, dim>(*node++), basis.gradient(unit_x));
    return J;
  }



  template <int dim>
  Point<dim>
  NormalStress<dim>::position(const Point<dim> &unit_point) const
  {
    Point<dim> x;
    if (cell->reference_cell().is_simplex())
      {
        for (unsigned int i = 0; i < nodes.size(); ++i)
          x += simplex->shape_value(i, unit_point) * nodes[i];
        return x;
      }
    const LagrangePolynomials<dim> basis(geometry_degree, unit_point);
    auto                           node = nodes.begin();
    for (const auto &unit_x : lattice)
      x += basis.value(unit_x) * *node++;
    return x;
  }



  // FE_Q has the same functions, but evaluates each by itself, which takes ten times as long.
  template <int dim>
  std::vector<Tensor<1, dim>>
  NormalStress<dim>::shape_gradients(const Point<dim> &unit_point) const
  {
    const FiniteElement<dim>   &fe = cell->get_fe().base_element(0);
    std::vector<Tensor<1, dim>> result;
    result.reserve(fe.n_dofs_per_cell());
    if (cell->reference_cell().is_simplex())
      for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
        result.push_back(fe.shape_grad(i, unit_point));
    else
      {
        const LagrangePolynomials<dim> basis(fe.degree, unit_point);
        for (const auto &place : lattices[cell->active_fe_index()])
          result.push_back(basis.gradient(place));
      }
    return result;
  }



  // The row of n . sigma m over the degrees of freedom of the cell, at small strain (doc/theory,
  // (1.1), (2.12)).
  template <int dim>
  std::vector<double>
  NormalStress<dim>::coefficients(const Point<dim>     &unit_point,
                                  const Tensor<1, dim> &n,
                                  const Tensor<1, dim> &m) const
  {
    // n . sigma m = lambda div u n.m + mu (n . grad u m + m . grad u n)
    const Material      &material = elasticity.material(cell->material_id());
    const double         lambda   = in_plane_lambda(elasticity.model(), material);
    const Tensor<2, dim> nm       = outer_product(n, m);
    return product_with_gradient(in_space(material.mu() * (nm + transpose(nm))) +
                                   lambda * (n * m) * Tensor<2, 3>(unit_symmetric_tensor<3>()),
                                 unit_point);
  }



  // The row of n . sigma m with global indices: n is the contact normal, m the outward normal of
  // the face on which the traction acts.
  template <int dim>
  SparseRow
  NormalStress<dim>::row(const Point<dim>     &unit_point,
                         const Tensor<1, dim> &n,
                         const Tensor<1, dim> &m) const
  {
    return resolved(coefficients(unit_point, n, m));
  }



  // The row with indices, without zeros, hanging nodes condensed.
  template <int dim>
  SparseRow
  NormalStress<dim>::resolved(const std::vector<double> &values) const
  {
    SparseRow result;
    for (unsigned int i = 0; i < values.size(); ++i)
      if (values[i] != 0)
        result.emplace_back(indices[i], values[i]);
    condense_hanging_nodes(elasticity.hanging_nodes(), result);
    return result;
  }



  namespace
  {
    /// The tensor n . (dP/dF) N, with dP_aJ/dF_bL = delta_ab S_JL + F_aI (2 dS/dC)_IJKL F_bK
    /// (doc/theory, (6.3)).
    Tensor<2, 3>
    derivative(const ConstitutiveResponse &state,
               const Tensor<2, 3>         &F,
               const Tensor<1, 3>         &n,
               const Tensor<1, 3>         &N)
    {
      const SymmetricTensor<2, 3> pulled = symmetrize(outer_product(transpose(F) * n, N));
      return outer_product(n, Tensor<2, 3>(state.stress) * N) +
             F * Tensor<2, 3>(pulled * state.tangent);
    }
  } // namespace



  // The row of V : Grad u over the degrees of freedom of the cell; in axisymmetric models with the
  // hoop part V_zz u_r/r, on the axis its limit V_zz du_r/dr.
  template <int dim>
  std::vector<double>
  NormalStress<dim>::product_with_gradient(const Tensor<2, 3> &V, const Point<dim> &unit_x) const
  {
    const auto          &fe              = cell->get_fe();
    const Tensor<2, dim> to_real         = transpose(invert(jacobian(unit_x)));
    const bool           is_axisymmetric = elasticity.model() == Model::axisymmetric;
    const double         r               = is_axisymmetric ? position(unit_x)[0] : 0.;
    const auto           by_unit         = shape_gradients(unit_x);
    std::vector<double>  result(indices.size());
    for (unsigned int i = 0; i < by_unit.size(); ++i)
      {
        const Tensor<1, dim> gradient = to_real * by_unit[i];
        for (unsigned int d = 0; d < dim; ++d)
          {
            // Row d of V multiplies the gradient of component d.
            double &sum = result[fe.component_to_system_index(d, i)];
            for (unsigned int e = 0; e < dim; ++e)
              sum += V[d][e] * gradient[e];
            if (d == 0 && is_axisymmetric)
              sum +=
                V[2][2] * (r > 0 ? fe.base_element(0).shape_value(i, unit_x) / r : gradient[0]);
          }
      }
    return result;
  }



  // Contact carries the part of sigma N that surface loads do not: they are subtracted.
  template <int dim>
  BodyStress
  NormalStress<dim>::at(const Point<dim>                  &unit_point,
                        const std::vector<Tensor<1, dim>> &directions,
                        const Tensor<1, dim>              &N,
                        const SurfaceLoad<dim>            &load) const
  {
    if (elasticity.is_finite_strain())
      return cauchy(unit_point, directions, N, load);
    BodyStress result;
    for (const Tensor<1, dim> &n : directions)
      result.components.push_back({row(unit_point, n, N),
                                   thermal_row(unit_point, n, N),
                                   volumetric_row(unit_point, n, N),
                                   -(n * load.on(N)),
                                   0.});
    return result;
  }



  // Cauchy stress of a point with its linearisation at fixed n (doc/theory, (6.13), (6.14)).
  template <int dim>
  BodyStress
  NormalStress<dim>::cauchy(const Point<dim>                  &unit_x,
                            const std::vector<Tensor<1, dim>> &directions,
                            const Tensor<1, dim>              &N_at_rest,
                            const SurfaceLoad<dim>            &load) const
  {
    const VolumetricStress<dim> &volumetric = elasticity.volumetric_stress();
    const auto                  &fe         = cell->get_fe();
    // Displacement and its gradient at the point in the reference configuration.
    const Tensor<2, dim> to_real = transpose(invert(jacobian(unit_x)));
    const Point<dim>     X       = position(unit_x);
    const auto           by_unit = shape_gradients(unit_x);
    std::vector<double>  u(indices.size());
    Tensor<2, dim>       gradient;
    Tensor<1, dim>       value;
    for (unsigned int i = 0; i < u.size(); ++i)
      {
        u[i]                       = displacement(indices[i]);
        const auto [d, node]       = fe.system_to_component_index(i);
        const Tensor<1, dim> slope = to_real * by_unit[node];
        value[d] += u[i] * fe.base_element(0).shape_value(node, unit_x);
        gradient[d] += u[i] * slope;
      }
    const Tensor<1, 3> N = in_space(N_at_rest);
    Tensor<2, 3>       F = deformation_gradient(elasticity.model(), gradient, value, X);
    // In plane stress, of lengths in the plane: both bodies share these, not their thickness.
    const Tensor<2, 3>  in_plane = F;
    std::vector<double> internal;
    const MaterialPoint point = elasticity.material_point(*cell, X, internal);
    const auto          found = response_if_any(elasticity.model(), point, F);
    BodyStress          result;
    result.components.resize(directions.size());
    // An inverted cell has no stress; NaN is reported by the caller on all ranks.
    if (!found)
      {
        for (StressRow &component : result.components)
          component.value = component.offset = std::nan("");
        return result;
      }
    // Cofactor J F^-T N: its length is the area ratio j, its direction the current normal m_c.
    const ConstitutiveResponse &state    = *found;
    const Tensor<2, 3>          inverse  = invert(in_plane);
    const Tensor<1, 3>          cofactor = determinant(in_plane) * (transpose(inverse) * N);
    const double                j        = cofactor.norm();
    const Tensor<1, 3>          now      = cofactor / j;
    // Derivatives as tensors V with d(.) = V : dF: of j, and of the force n . (P N) + p n . (j
    // m_c).
    // dj = j (F^-T - m_c (x) F^-1 m_c) : dF, the derivative of the length of the cofactor (Nanson's
    // formula); the load term is the derivative of p j m_c . n.
    const Tensor<2, 3> of_ratio = j * (transpose(inverse) - outer_product(now, inverse * now));
    const double       p        = load.pressure;
    // The offsets are such that value = row . u + volumetric part + offset at the present
    // displacement.
    const auto product = [&](const std::vector<double> &row) {
      return std::inner_product(row.begin(), row.end(), u.begin(), 0.);
    };
    const std::vector<double> ratio = product_with_gradient(of_ratio, unit_x);
    result.ratio                    = j;
    result.ratio_row                = resolved(ratio);
    result.ratio_offset             = j - product(ratio);
    for (unsigned int a = 0; a < directions.size(); ++a)
      {
        // Value, and the rows of the quotient force/j.
        StressRow         &component     = result.components[a];
        const Tensor<1, 3> n             = in_space(directions[a]);
        const double       of_volumetric = n * (transpose(inverse) * N) / j;
        const Tensor<2, 3> of_force =
          derivative(state, F, n, N) +
          p * j * ((n * now) * transpose(inverse) - outer_product(now, inverse * n));
        component.value =
          n * (F * (Tensor<2, 3>(state.stress) * N) - in_space(load.traction)) / j + p * (n * now);
        const std::vector<double> row =
          product_with_gradient(of_force / j - (component.value / j) * of_ratio, unit_x);
        component.displacement = resolved(row);
        component.offset = component.value - point.volumetric_stress * of_volumetric - product(row);
        if (!volumetric.is_on(*cell))
          continue;
        const auto  phi    = volumetric.functions(*cell, X);
        const auto &number = volumetric.indices(*cell);
        for (unsigned int i = 0; i < phi.size(); ++i)
          component.volumetric.emplace_back(number[i], phi[i] * of_volumetric);
      }
    // Ratio by which the tangent stiffens the bound (6.15).
    const Material &material = elasticity.material(cell->material_id());
    const double    at_rest  = in_plane_lambda(elasticity.model(), material) + 2 * material.mu();
    result.stiffening =
      std::max(1., scalar_product(derivative(state, F, now, N), outer_product(now, N)) / at_rest);
    return result;
  }



  // The thermal part of the normal stress, -n . (C : alpha) m per unit of the temperature rise, as
  // a row over the coefficients of the rise in the cell.
  template <int dim>
  SparseRow
  NormalStress<dim>::thermal_row(const Point<dim>     &unit_point,
                                 const Tensor<1, dim> &n,
                                 const Tensor<1, dim> &m) const
  {
    const ThermalStrain<dim> &thermal = elasticity.thermal();
    const unsigned int        id      = cell->material_id();
    if (!thermal.expands(id))
      return {};
    const Tensor<1, 3> of_unit_rise = thermal.stress_of_unit_rise(elasticity.material(id), id);
    double             normal       = 0;
    for (unsigned int d = 0; d < dim; ++d)
      normal += n[d] * of_unit_rise[d] * m[d];
    SparseRow result = thermal.row(*cell, position(unit_point));
    for (auto &entry : result)
      entry.second *= -normal;
    return result;
  }



  // The part m n . m of the normal stress of bodies in displacement-pressure form, over the
  // coefficients of the volumetric stress.
  template <int dim>
  SparseRow
  NormalStress<dim>::volumetric_row(const Point<dim>     &unit_point,
                                    const Tensor<1, dim> &n,
                                    const Tensor<1, dim> &m) const
  {
    const VolumetricStress<dim> &volumetric = elasticity.volumetric_stress();
    if (!volumetric.is_on(*cell))
      return {};
    const auto  phi    = volumetric.functions(*cell, position(unit_point));
    const auto &number = volumetric.indices(*cell);
    SparseRow   result;
    for (unsigned int i = 0; i < phi.size(); ++i)
      result.emplace_back(number[i], phi[i] * (n * m));
    return result;
  }



  template class NormalStress<2>;
  template class NormalStress<3>;
} // namespace Signorini
