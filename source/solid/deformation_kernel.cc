// SPDX-License-Identifier: Apache-2.0
#include "solid/deformation_kernel.h"

#include "materials/symmetric_pairs.h"
#include "solid/elasticity.h"
#include "solid/gradient_at_point.h"
#include "solid/scalar_elements.h"


namespace Signorini
{
  using namespace dealii;

  // Components of gradients are dim^2, plus the hoop component in axisymmetric models. Gauss
  // points: degree + 1 in each direction, as for the linear stiffness.
  template <int dim>
  DeformationKernel<dim>::DeformationKernel(const Mesh<dim>             &mesh,
                                            const hp::FECollection<dim> &all_elements,
                                            const Model                  model,
                                            const VolumetricStress<dim> *volumetric_stress,
                                            const MaterialHistory<dim>  *history,
                                            const ThermalStrain<dim>    *thermal)
    : model(model)
    , volumetric_stress(volumetric_stress)
    , history(history)
    , thermal(thermal)
    , n_components(dim * dim + (model == Model::axisymmetric ? 1 : 0))
    , elements(scalar_elements(all_elements))
    , all_values(mesh.mappings(),
                 elements,
                 gauss_rules(all_elements, 1),
                 update_values | update_gradients | update_JxW_values | update_quadrature_points |
                   update_inverse_jacobians)
    , all_dofs(dofs_of_nodes(all_elements))
  {}



  // Evaluate the scalar shape functions at the Gauss points of a cell, with the mapping, rule and
  // element of its degree. The values and the numbering of its nodes are valid until the next cell.
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



  // F = 1 + Grad u of the reference configuration, with the hoop stretch in axisymmetric models.
  template <int dim>
  Tensor<2, 3>
  DeformationKernel<dim>::gradient(const unsigned int q, const Vector<double> &u) const
  {
    return gradient_at_point(model, *values, *dofs, q, u);
  }



  // The gradients dN_i/dX_J and, in axisymmetric models, N_i/R of the present point.
  template <int dim>
  void
  DeformationKernel<dim>::read_slopes(const unsigned int q)
  {
    const bool has_hoop = n_components > dim * dim;
    slopes.resize(dofs->size() / dim);
    for (unsigned int i = 0; i < slopes.size(); ++i)
      {
        // The last entry is the factor of the radial displacement in the hoop component; zero in
        // other models.
        const Tensor<1, dim> &gradient = values->shape_grad(i, q);
        for (unsigned int J = 0; J < dim; ++J)
          slopes[i][J] = gradient[J];
        slopes[i][dim] = has_hoop ? values->shape_value(i, q) / values->quadrature_point(q)[0] : 0.;
      }
  }



  // dP_aJ/dF_bL = delta_ab S_JL + F_aI T_IJKL F_bK (doc/theory, (6.3)) between the components of
  // gradients; only the lower triangle is computed. At small strain F is 1 and the first term is
  // omitted.
  template <int dim>
  typename DeformationKernel<dim>::Tangent
  DeformationKernel<dim>::derivative(const Tensor<2, 3> &F, const ConstitutiveResponse &state) const
  {
    // A component is the pair (a, J) of a gradient entry; the last one of axisymmetric models is
    // the hoop entry (2, 2).
    const auto place = [](const unsigned int component) {
      return component < dim * dim ?
               std::pair<unsigned int, unsigned int>(component / dim, component % dim) :
               std::pair<unsigned int, unsigned int>(2, 2);
    };
    // Expand the symmetric tensor once, then contract with F_aI before F_bK, so that the tensor of
    // fourth order is read only once.
    double T[3][3][3][3];
    using Pairs = SymmetricPairs;
    for (unsigned int p = 0; p < Pairs::size; ++p)
      {
        const unsigned int  I = Pairs::row[p], J = Pairs::column[p];
        const double *const from = Pairs::row_of(state.tangent, p);
        for (unsigned int q = 0; q < Pairs::size; ++q)
          {
            const unsigned int K = Pairs::row[q], L = Pairs::column[q];
            T[I][J][K][L] = T[J][I][K][L] = T[I][J][L][K] = T[J][I][L][K] = from[q];
          }
      }
    Tangent result{};
    for (unsigned int m = 0; m < n_components; ++m)
      {
        const auto [a, J] = place(m);
        // First contraction: sum_I F_aI T_IJKL for the fixed pair (a, J), which is needed by all n.
        double moved[3][3]; // K, L
        for (unsigned int K = 0; K < 3; ++K)
          for (unsigned int L = 0; L < 3; ++L)
            moved[K][L] =
              F[a][0] * T[0][J][K][L] + F[a][1] * T[1][J][K][L] + F[a][2] * T[2][J][K][L];
        for (unsigned int n = 0; n <= m; ++n)
          {
            const auto [b, L] = place(n);
            double value      = a == b && !is_small ? state.stress[J][L] : 0.;
            for (unsigned int K = 0; K < 3; ++K)
              value += moved[K][L] * F[b][K];
            result[m][n] = result[n][m] = value;
          }
      }
    return result;
  }



  // The response of the material at quadrature point q, with volumetric stress, history and
  // temperature of the point.
  template <int dim>
  std::optional<ConstitutiveResponse>
  DeformationKernel<dim>::state(const Cell         &cell,
                                const unsigned int  q,
                                const Material     &material,
                                const ResponseOrder wanted,
                                Tensor<2, 3>       &F)
  {
    const Point<dim>   &x = values->quadrature_point(q);
    const MaterialPoint point(material,
                              volumetric_stress ? volumetric_stress->value(*cell, x) : 0.,
                              history ? history->at(*cell, q) : nullptr,
                              history ? history->duration() : 0.,
                              thermal && thermal->any() ? thermal->temperature_change(*cell, x) :
                                                          0.);
    // At small strain forces and tangents are those of finite strain with F = 1: P = S, and the
    // geometric term is omitted in derivative().
    is_small    = point.strain_measure == StrainMeasure::small;
    auto result = response_if_any(model, point, F, wanted);
    if (is_small)
      F = unit_symmetric_tensor<3>();
    return result;
  }



  // The tangent in reference coordinates of the cell, w J^-1 (dP/dF) J^-T, of which 45 entries are
  // stored (doc/theory, 7.1).
  template <int dim>
  CellTangent
  DeformationKernel<dim>::in_unit_coordinates(const Tangent &D, const unsigned int q) const
  {
    const auto  &inverse = values->inverse_jacobian(q); // dxi_d/dX_J
    const double weight  = values->JxW(q);
    CellTangent  result{};
    for (unsigned int c = 0; c < dim; ++c)
      // Blocks of the components c and e of the displacement; the tangent is symmetric, and of the
      // diagonal blocks the lower triangle is stored.
      for (unsigned int e = 0; e <= c; ++e)
        {
          // The factor J^-T on the right first, since it is the same for all derivatives d on the
          // left.
          double right[dim][dim]; // J, f
          for (unsigned int J = 0; J < dim; ++J)
            for (unsigned int f = 0; f < dim; ++f)
              {
                right[J][f] = 0;
                for (unsigned int L = 0; L < dim; ++L)
                  right[J][f] += D[dim * c + J][dim * e + L] * inverse[f][L];
              }
          for (unsigned int d = 0; d < dim; ++d)
            for (unsigned int f = 0; f < (c == e ? d + 1 : dim); ++f)
              {
                double sum = 0;
                for (unsigned int J = 0; J < dim; ++J)
                  sum += inverse[d][J] * right[J][f];
                result[tangent_number(dim * c + d, dim * e + f)] = weight * sum;
              }
        }
    return result;
  }



  // The tangents of all quadrature points of a cell, for matrix-free products (doc/theory, 7.9).
  // Returns false, with some of the points only, if the cell is inverted.
  template <int dim>
  bool
  DeformationKernel<dim>::tangents(const Cell           &cell,
                                   const Material       &material,
                                   const Vector<double> &u,
                                   CellTangents         &points)
  {
    Assert(dim == 3, ExcNotImplemented());
    reinit(cell);
    points.clear();
    for (const unsigned int q : values->quadrature_point_indices())
      {
        Tensor<2, 3>                              F = gradient(q, u);
        const std::optional<ConstitutiveResponse> found =
          state(cell, q, material, ResponseOrder::tangent, F);
        if (!found)
          return false;
        points.push_back(in_unit_coordinates(derivative(F, *found), q));
      }
    return true;
  }



  // f_i += w P_dJ dN_i/dX_J, with the hoop part P_zz N_i/R of the radial component.
  template <int dim>
  void
  DeformationKernel<dim>::add_forces(const Tensor<2, 3> &P,
                                     const double        weight,
                                     Vector<double>     &forces) const
  {
    for (unsigned int i = 0; i < slopes.size(); ++i)
      for (unsigned int d = 0; d < dim; ++d)
        {
          double f = d == 0 ? slopes[i][dim] * P[2][2] : 0.;
          for (unsigned int J = 0; J < dim; ++J)
            f += slopes[i][J] * P[d][J];
          forces((*dofs)[i * dim + d]) += weight * f;
        }
  }



  // K_ij += w dN_i/dX D dN_j/dX: first the stress due to function i for all gradients, then its
  // product with function j <= i.
  template <int dim>
  void
  DeformationKernel<dim>::add_tangent(const Tangent &D, const double weight)
  {
    const bool         has_hoop = n_components > dim * dim;
    const unsigned int n        = dofs->size();
    for (unsigned int i = 0; i < slopes.size(); ++i)
      for (unsigned int d = 0; d < dim; ++d)
        {
          Components stress{}; // by gradients of the other function
          for (unsigned int m = 0; m < n_components; ++m)
            {
              double value = has_hoop && d == 0 ? slopes[i][dim] * D[dim * dim][m] : 0.;
              for (unsigned int J = 0; J < dim; ++J)
                value += slopes[i][J] * D[d * dim + J][m];
              stress[m] = weight * value;
            }
          // Rows are contiguous: entry (i dim + d, j dim + e) with nodes in the order of the scalar
          // element. Only j <= i is written.
          double *at = &sums[(i * dim + d) * n];
          for (unsigned int j = 0; j <= i; ++j)
            for (unsigned int e = 0; e < dim; ++e)
              {
                double value = 0;
                for (unsigned int L = 0; L < dim; ++L)
                  value += stress[e * dim + L] * slopes[j][L];
                if (has_hoop && e == 0)
                  value += stress[dim * dim] * slopes[j][dim];
                *at++ += value;
              }
        }
  }



  // Quadrature over the cell: forces (6.2) and, if wanted, the tangent (6.3). Cost: O(points x
  // functions^2) for the tangent.
  template <int dim>
  bool
  DeformationKernel<dim>::assemble(const Cell           &cell,
                                   const Material       &material,
                                   const Vector<double> &u,
                                   Vector<double>       &forces,
                                   FullMatrix<double>   *tangent)
  {
    reinit(cell);
    const unsigned int n = dofs->size();
    forces.reinit(n);
    if (tangent)
      sums.assign(n * n, 0.);
    for (const unsigned int q : values->quadrature_point_indices())
      {
        Tensor<2, 3>                              F = gradient(q, u);
        const std::optional<ConstitutiveResponse> found =
          state(cell, q, material, tangent ? ResponseOrder::tangent : ResponseOrder::stress, F);
        if (!found)
          return false;
        const double weight = values->JxW(q) * measure(model, values->quadrature_point(q));
        read_slopes(q);
        add_forces(F * Tensor<2, 3>(found->stress), weight, forces);
        if (tangent)
          add_tangent(derivative(F, *found), weight);
      }
    if (!tangent)
      return true;
    // The lower triangle of `sums`, numbered node by node, becomes the full symmetric matrix in the
    // numbering of the cell.
    tangent->reinit(n, n);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j <= i; ++j)
        {
          const unsigned int row = (*dofs)[i], column = (*dofs)[j];
          (*tangent)(row, column) = (*tangent)(column, row) = sums[i * n + j];
        }
    return true;
  }



  // The internal variables that the law would have at the end of the step, point by point; empty if
  // the cell is inverted.
  template <int dim>
  PointVariables
  DeformationKernel<dim>::internal(const Cell           &cell,
                                   const Material       &material,
                                   const Vector<double> &u)
  {
    reinit(cell);
    PointVariables result;
    // The number of points on a line tells the receiver of these values, which may have another
    // mesh, which polynomial they define.
    result.points_per_line = cell->get_fe().degree + 1;
    for (const unsigned int q : values->quadrature_point_indices())
      {
        Tensor<2, 3> F     = gradient(q, u);
        const auto   found = state(cell, q, material, ResponseOrder::stress, F);
        if (!found)
          return {};
        result.values.insert(result.values.end(), found->internal.begin(), found->internal.end());
      }
    return result;
  }



  // det F at all Gauss points of a cell, for the step length (doc/theory, 4.7); valid until the
  // next call.
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



  // Without displacement-pressure form, internal variables or temperatures these are empty.
  template <int dim>
  DeformationKernel<dim>
  deformation_kernel(const Elasticity<dim> &elasticity)
  {
    return {elasticity.mesh(),
            elasticity.finite_elements(),
            elasticity.model(),
            &elasticity.volumetric_stress(),
            &elasticity.material_history(),
            &elasticity.thermal()};
  }



  template class DeformationKernel<2>;
  template class DeformationKernel<3>;
  template DeformationKernel<2>
  deformation_kernel(const Elasticity<2> &);
  template DeformationKernel<3>
  deformation_kernel(const Elasticity<3> &);
} // namespace Signorini
