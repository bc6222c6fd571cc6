// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/constraints/contact_rows.h"
#include "contact/constraints/gap_operator.h"
#include "contact/constraints/tangents.h"
#include "contact/constraints/trace.h"
#include "contact/search/configuration.h"
#include "solid/kernel.h"
#include "solid/surface_loads.h"

#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/lac/full_matrix.h>

#include <array>
#include <memory>
#include <vector>

namespace Signorini
{
  /// The directions of the components of the stress at a contact point: the contact normal n, and
  /// vectors_across(n) if the method uses the slip.
  template <int dim>
  std::vector<dealii::Tensor<1, dim>>
  stress_directions(const dealii::Tensor<1, dim> &n, const bool with_slip)
  {
    std::vector<dealii::Tensor<1, dim>> result = {n};
    if (with_slip)
      for (const dealii::Tensor<1, dim> &across : vectors_across(n))
        result.push_back(across);
    return result;
  }

  /// Components of the stress of a body at a point of its boundary along unit vectors n. At small
  /// strain n . sigma N with the normal N; at finite strain those of the Cauchy stress, and their
  /// linearisation (doc/theory, (6.13), (6.14)):
  ///
  ///   sigma = n.(P N - t)/j + p n.m,  j = |cof F N|,
  ///   d sigma = (n.(dP/dF : dF) N + p n.d(j m) - (sigma) dj)/j,
  ///   dj = j (tr(dF F^-1) - m.dF F^-1 m),  n.d(j m) = j (n.m tr(dF F^-1) - m.dF F^-1 n),
  ///
  /// where N is the normal in the reference configuration, m the current one, and n is kept fixed.
  /// The traction t of loads, per reference area, and their pressure p are subtracted, since
  /// contact does not carry them.
  struct BodyStress
  {
    std::vector<StressRow> components;
    /// The current area per reference area j; 1 at small strain.
    double    ratio = 1;
    SparseRow ratio_row;        ///< the derivative of j, by degrees of freedom
    double    ratio_offset = 1; ///< j - ratio_row.u at the present state
    /// The ratio (6.15) by which the tangent stiffens the bound, at least 1.
    double stiffening = 1;
  };

  /// The stress of a body at its boundary, evaluated in the cell behind a face. Keeps a reference
  /// to its arguments.
  template <int dim>
  class NormalStress
  {
  public:
    using Cell = typename Trace<dim>::Cell;

    NormalStress(const Elasticity<dim> &elasticity);

    /// For at(), in a displaced configuration at finite strain. Collective.
    NormalStress(const Configuration<dim> &configuration);

    /// Set the cell for the functions below.
    void
    reinit(const Cell &cell);

    /// The components of the stress at a point of the reference cell; not a number where the cell
    /// is inverted at finite strain.
    /// @param directions unit vectors n, in the current configuration
    /// @param N outward normal of the body in the reference configuration
    /// @param load surface loads there
    BodyStress
    at(const dealii::Point<dim>                  &unit_point,
       const std::vector<dealii::Tensor<1, dim>> &directions,
       const dealii::Tensor<1, dim>              &N,
       const SurfaceLoad<dim>                    &load = {}) const;

    /// n . sigma(u) m at a point of the reference cell, in terms of degrees of freedom (hanging
    /// nodes resolved).
    SparseRow
    row(const dealii::Point<dim>     &unit_point,
        const dealii::Tensor<1, dim> &n,
        const dealii::Tensor<1, dim> &m) const;

    /// The row of the part of the stress that depends on temperature changes, - n . (C : alpha) m
    /// (T - T_0), over ThermalStrain::coefficients(). Empty if the body does not expand.
    SparseRow
    thermal_row(const dealii::Point<dim>     &unit_point,
                const dealii::Tensor<1, dim> &n,
                const dealii::Tensor<1, dim> &m) const;

    /// The row of the part of the stress that depends on the volumetric stress, over
    /// VolumetricStress::coefficients(). Empty if the body is not in displacement-pressure form.
    SparseRow
    volumetric_row(const dealii::Point<dim>     &unit_point,
                   const dealii::Tensor<1, dim> &n,
                   const dealii::Tensor<1, dim> &m) const;

    /// The smallest C with
    ///
    ///   int_F (n . sigma(u) n)^2 dA <= C int_T sigma(u) : eps(u) dV
    ///
    /// for all displacements u of the cell T, n being the normal of its face F: the largest
    /// eigenvalue of the generalised problem, which is of the order of E/h [force/length^3]
    /// (doc/theory, 2.7; Griebel, Schweitzer, Geometric Analysis and Nonlinear PDE (2002) 519-542).
    /// In mixed bodies the same of the volumetric stress is added, with int_T m^2/(2 mu) dV.
    /// @param with_slip true: of the whole vector sigma(u) n, not of its normal component
    double
    bound(unsigned int face, bool with_slip);

  private:
    /// The components of at() at finite strain.
    BodyStress
    cauchy(const dealii::Point<dim>                  &unit_point,
           const std::vector<dealii::Tensor<1, dim>> &directions,
           const dealii::Tensor<1, dim>              &N,
           const SurfaceLoad<dim>                    &load) const;

    /// The entries of row(), for each degree of freedom of the cell.
    std::vector<double>
    coefficients(const dealii::Point<dim>     &unit_point,
                 const dealii::Tensor<1, dim> &n,
                 const dealii::Tensor<1, dim> &m) const;

    /// The bound of the volumetric stress that is added in displacement-pressure form
    /// [force/length^3].
    double
    bound_of_volumetric_stress(unsigned int face) const;

    /// Convert coefficients of the cell's shape functions to a row over degrees of freedom, hanging
    /// nodes condensed.
    /// @param values one for each degree of freedom of the cell
    SparseRow
    resolved(const std::vector<double> &values) const;

    /// The gradients of the shape functions of a component by the reference coordinates.
    std::vector<dealii::Tensor<1, dim>>
    shape_gradients(const dealii::Point<dim> &unit_point) const;

    /// V : Grad u, for each degree of freedom of the cell.
    std::vector<double>
    product_with_gradient(const dealii::Tensor<2, 3> &V, const dealii::Point<dim> &unit_x) const;

    /// Position and Jacobian matrix of the cell's mapping at a point of the reference cell.
    dealii::Point<dim>
    position(const dealii::Point<dim> &unit_point) const;

    dealii::Tensor<2, dim>
    jacobian(const dealii::Point<dim> &unit_point) const;

    const Elasticity<dim>                     &elasticity;
    LA::Vector                                 displacement; ///< with ghosts; empty: at rest
    const unsigned int                         geometry_degree;
    StiffnessKernel<dim>                       kernel;
    std::vector<std::array<unsigned int, dim>> lattice; ///< places of the geometry's nodes
    /// Those of the nodes of quadrilaterals and hexahedra, for each element.
    std::vector<std::vector<std::array<unsigned int, dim>>> lattices;
    /// The element of the geometry of simplices; null if there are none.
    std::shared_ptr<const dealii::FE_SimplexP<dim>> simplex;
    Cell                                            cell;
    std::vector<dealii::Point<dim>>                 nodes; ///< of the geometry
    std::vector<dealii::types::global_dof_index>    indices;
  };

  /// The rows of B and S to which some points of one slave face contribute, as dense matrices:
  /// adding them at once costs a fraction of adding them point by point.
  struct FaceMatrix
  {
    std::vector<dealii::types::global_dof_index> rows, columns;
    dealii::FullMatrix<double>                   displacement;
    std::vector<dealii::FullMatrix<double>>      stress; ///< its components; empty: none
    std::vector<dealii::FullMatrix<double>>      slip;   ///< along each tangent
  };

  /// Call add(a, stress, factor) for the terms, factor times stress, of each component a of the
  /// stress at point q of a surface, along the directions of a row of the gap operator.
  /// @param tangents null: the method does not use the slip
  template <int dim, typename Add>
  void
  for_each_stress(const ContactSurface<dim>            &surface,
                  const unsigned int                    q,
                  const Tangents<dim>                  *tangents,
                  const dealii::types::global_dof_index row,
                  const Add                            &add)
  {
    const ContactPoint<dim> &point = surface.points[q];
    if (point.stress.empty())
      return;
    add(0u, point.stress[0], 1.);
    if (!tangents)
      return;
    const auto along  = tangents->at(row, surface.frames[q], point.direction);
    const auto across = vectors_across(point.direction);
    for (unsigned int a = 0; a < dim - 1; ++a)
      for (unsigned int b = 0; b < dim - 1; ++b)
        add(1 + a, point.stress[1 + b], along[a] * across[b]);
  }

  /// The matrices of all contact points of this rank, multiplied by the points' areas.
  /// @param tangents along which the slip is measured; null: the method does not use it
  /// @param all_components true: keep columns of all displacement components, since inclined
  /// supports may eliminate some in terms of others; false: only components along which normals are
  /// not zero
  template <int dim>
  std::vector<FaceMatrix>
  face_matrices(const ContactRows                      &rows,
                const std::vector<ContactSurface<dim>> &surfaces,
                Sampling                                sampling,
                const Tangents<dim>                    *tangents,
                bool                                    all_components);

  /// Assemble the dependence of the stress at the contact points on fields other than the
  /// displacement: GapOperator::S_thermal on temperature changes (empty if no body expands),
  /// S_volumetric on the volumetric stress (empty if no body is in displacement-pressure form), and
  /// the constant part fixed_stress. The areas of the points must be set before.
  /// @param tangents as of face_matrices()
  template <int dim>
  void
  assemble_field_stress(const Elasticity<dim>                  &elasticity,
                        const ContactRows                      &rows,
                        const std::vector<ContactSurface<dim>> &surfaces,
                        const Tangents<dim>                    *tangents,
                        GapOperator                            &contact);
} // namespace Signorini
