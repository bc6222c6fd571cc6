// SPDX-License-Identifier: Apache-2.0
// The bound of the stress on a face by the strain energy of a cell.
#include "contact/search/face_patch.h"
#include "contact/traction/normal_stress.h"
#include "geometry/cell_rule.h"
#include "linear_algebra/dense.h"

#include <deal.II/lac/full_matrix.h>

#include <cmath>

namespace Signorini
{
  using namespace dealii;

  // 2 mu max int_F m^2/int_T m^2 (doc/theory, 2.7), the largest eigenvalue of the mass matrix on
  // the face with respect to that of the cell. With the former as V V^T, V^T M^-1 V has the same
  // one.
  template <int dim>
  double
  NormalStress<dim>::bound_of_volumetric_stress(const unsigned int face) const
  {
    const VolumetricStress<dim> &volumetric = elasticity.volumetric_stress();
    if (!volumetric.is_on(*cell))
      return 0;
    constexpr unsigned int n = VolumetricStress<dim>::functions_per_cell;
    // The functions are linear, so that their products are integrated exactly on plane faces.
    const FacePatch<dim> patch(elasticity.mesh().mapping(), geometry_degree, cell, face);
    const auto          &rule = cell_rule<dim - 1>(patch.reference_cell(), 3);
    Eigen::MatrixXd      values(n, rule.size()); // times the square roots of the areas
    for (unsigned int q = 0; q < rule.size(); ++q)
      {
        const Point<dim> x    = patch.position(rule.point(q));
        const auto       phi  = volumetric.functions(*cell, x);
        const double     root = std::sqrt(rule.weight(q) * patch.jacobian(rule.point(q)) *
                                      measure(elasticity.model(), x));
        for (unsigned int i = 0; i < n; ++i)
          values(i, q) = root * phi[i];
      }
    Eigen::MatrixXd mass(n, n);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        mass(i, j) = volumetric.mass(*cell)[i][j];
    return 2 * elasticity.material(cell->material_id()).mu() *
           eigenvalues_of_symmetric(values.transpose() * solve_symmetric(mass, values)).maxCoeff();
  }



  // Largest eigenvalue of the generalised problem S^T S v = b K v on the cell behind the face
  // (doc/theory, (2.17)), with the stresses S at Gauss points of the face, weighted with the roots
  // of areas: that of S K^-1 S^T, which has as many rows as there are points. StressBounds keeps
  // the results.
  template <int dim>
  double
  NormalStress<dim>::bound(const unsigned int face, const bool with_slip)
  {
    const unsigned int n = indices.size();
    // The stiffness of the cell at small strain: its quadratic form is twice the energy of a
    // virtual displacement.
    FullMatrix<double> stiffness;
    kernel.assemble(cell, elasticity.material(cell->material_id()), stiffness);
    Eigen::MatrixXd K(n, n);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        K(i, j) = stiffness(i, j);

    const FacePatch<dim> patch(elasticity.mesh().mapping(), geometry_degree, cell, face);
    const auto        &rule = cell_rule<dim - 1>(patch.reference_cell(), cell->get_fe().degree + 2);
    const unsigned int n_components = with_slip ? dim : 1;
    Eigen::MatrixXd    stress(n_components * rule.size(), n); // times the square roots of the areas
    for (unsigned int q = 0; q < rule.size(); ++q)
      {
        const Tensor<1, dim> normal     = patch.normal(rule.point(q));
        const auto           directions = stress_directions(normal, with_slip);
        const double         root       = std::sqrt(rule.weight(q) * patch.jacobian(rule.point(q)) *
                                      measure(elasticity.model(), patch.position(rule.point(q))));
        for (unsigned int a = 0; a < n_components; ++a)
          {
            const std::vector<double> row =
              coefficients(unit_point<dim>(cell->reference_cell(), face, rule.point(q)),
                           directions[a],
                           normal);
            for (unsigned int i = 0; i < n; ++i)
              stress(q * n_components + a, i) = root * row[i];
          }
      }

    // Both sides vanish on rigid-body modes. A stiffness of 1e-10 for these makes K regular and
    // does not change the others, since S maps rigid-body modes to zero.
    K.diagonal().array() += 1e-10 * K.diagonal().maxCoeff();
    return bound_of_volumetric_stress(face) +
           eigenvalues_of_symmetric(stress * solve_symmetric(K, stress.transpose())).maxCoeff();
  }



  template double
  NormalStress<2>::bound(unsigned int, bool);
  template double
  NormalStress<3>::bound(unsigned int, bool);
} // namespace Signorini
