// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "accuracy/quantity.h"
#include "solid/elasticity.h"
#include "solver/dual_solution.h"

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/hp/fe_values.h>

#include <vector>

namespace Signorini
{
  /// Recovers stresses of higher order from finite element solutions, (8.5): in each cell the
  /// polynomial of the degree of the displacement that fits the stress best at the superconvergent
  /// points of the cell and of all cells that share a vertex with it (Zienkiewicz, Zhu 1992, see
  /// doc/theory; cell by cell instead of vertex by vertex). At boundaries patches are one-sided,
  /// and the fit has the same order there. Patches do not extend to other bodies or materials. Only
  /// locally owned and ghost cells are needed, so that nothing is communicated after the
  /// construction.
  template <int dim>
  class RecoveredStress
  {
  public:
    using Cell   = typename dealii::DoFHandler<dim>::active_cell_iterator;
    using Stress = dealii::SymmetricTensor<2, 3>;

    /// A displacement, and whether thermal strain is part of its strain: it is for solutions, and
    /// not for their changes.
    struct Field
    {
      const LA::Vector *displacement;
      bool              has_thermal_strain;
    };

    /// Sample the stresses. Collective.
    /// @param elasticity to which the object refers
    /// @param fields whose displacements have no ghost values
    RecoveredStress(const Elasticity<dim> &elasticity, const std::vector<Field> &fields);

    /// The recovered stress minus that of the finite elements in one cell.
    struct Deviations
    {
      /// Quadrature weights of the points; in axisymmetric models including 2 pi r.
      std::vector<double> weights;
      /// Recovered minus computed stress, [field][point].
      std::vector<std::vector<Stress>> deviation;
      /// Computed stress, [field][point].
      std::vector<std::vector<Stress>> stress;
    };

    /// @return the deviations in a locally owned cell; valid until the next call.
    /// @param cell the cell
    const Deviations &
    operator()(const Cell &cell);

  private:
    /// Number of stress components: plane stresses have four.
    static constexpr unsigned int n_components = dim == 2 ? 4 : 6;

    /// @return the number of sample points in each direction; at least two across a body that is
    /// one cell thick, since one point would miss bending.
    unsigned int
    points_per_direction(const Cell &cell) const;
    /// @return the index of the rule with that many points in each direction.
    unsigned int
    rule(const Cell &cell, unsigned int points_per_direction) const;
    void
    sample();
    void
    find_neighbours();
    void
    collect_patch(const Cell &cell);
    /// Compute the stresses of all fields at the points of `values`.
    void
    stresses_at(const Cell                            &cell,
                const dealii::FEValues<dim>           &values,
                const std::vector<dealii::Point<dim>> &points,
                std::vector<std::vector<Stress>>      &result) const;

    const Elasticity<dim>  &elasticity;
    std::vector<LA::Vector> ghosted;
    std::vector<bool>       has_thermal_strain;

    // By the index of locally owned and ghost cells:
    /// Index of the first sample of each cell, and the end.
    std::vector<unsigned int>       first_sample;
    std::vector<dealii::Point<dim>> places;
    /// Stress components of all points, see sample().
    std::vector<double> samples;

    std::vector<unsigned int> first_at_vertex, cells_at_vertex, material_of_cell;
    /// Indices of the cells of the present patch.
    std::vector<unsigned int> patch;

    dealii::hp::QCollection<dim> rules;
    dealii::hp::FEValues<dim>    values;
    Deviations                   result;
  };

  /// Estimates of the error of a solution in each active cell; entries of cells of other ranks are
  /// zero.
  struct CellErrors
  {
    /// Square of the energy norm of the error, int e:sigma(e) dV.
    std::vector<double> energy;
    /// [quantity][cell]: the energy product of the errors of the solution and of the dual solution,
    /// (8.6).
    std::vector<std::vector<double>> products;
    /// For each quantity the square of the energy norm of the error of the dual solution, summed
    /// over all ranks.
    std::vector<double> energies_of_duals;
    /// int sigma:eps dV of the solution, summed over all ranks.
    double energy_of_solution = 0;
  };

  /// Estimate the errors by recovered stresses: with e the error of the solution and e_z that of a
  /// dual one, J(u) - J(u_h) = a(e, e_z) by Galerkin orthogonality, where the recovered stresses
  /// replace the exact ones, (8.6). Collective.
  /// @param elasticity the model
  /// @param displacement the solution
  /// @param duals dual displacements, one for each quantity
  /// @return the estimates
  template <int dim>
  CellErrors
  cell_errors(const Elasticity<dim>         &elasticity,
              const LA::Vector              &displacement,
              const std::vector<LA::Vector> &duals);

  /// Contributions of boundaries to the error of each quantity, (8.7), cell by cell, exact minus
  /// computed. Only entries of locally owned cells are set.
  struct BoundaryErrors
  {
    /// [quantity][cell]: supports prescribe more than the elements can follow. With z the dual
    /// displacement, - int sigma(z) n.(u_D - u_h) dA.
    std::vector<std::vector<double>> of_supports;
    /// [quantity][cell]: cells omit (d > 0) or add a strip of thickness d along a curved boundary
    /// (Hadamard's formula), and loads and supports act on the boundary of the cells instead of the
    /// true one: - int d (sigma(u):eps(z) - sigma(u) n.dz/dn - sigma(z) n.du/dn) dA.
    std::vector<std::vector<double>> of_geometry;
  };

  /// @return the contributions of boundaries. Collective.
  /// @param elasticity the model
  /// @param displacement the solution
  /// @param duals dual displacements, one for each quantity
  template <int dim>
  BoundaryErrors
  boundary_errors(const Elasticity<dim>         &elasticity,
                  const LA::Vector              &displacement,
                  const std::vector<LA::Vector> &duals);

  /// @return the size of the error by contact points that cannot move, such as a corner of the
  /// slave at a support: the support takes their pressure, and its share of the reaction is not
  /// determined. The mean pressure of the pair is assumed there: the sum over these points of area
  /// |B z + dJ/dp| times that pressure. Zero for methods that sample at quadrature points.
  /// Collective.
  /// @param snapshot the solution
  /// @param functional the quantity
  /// @param dual_displacement z of the quantity, without its lift
  template <int dim>
  double
  undetermined_contact(const Snapshot<dim> &snapshot,
                       const Functional    &functional,
                       const LA::Vector    &dual_displacement);

  /// @return the size of the error by faces that the edge of contact crosses, (8.9), on each active
  /// cell: the position of the force within such a face is not resolved. It is small for contact
  /// zones of many faces. Collective.
  /// @param snapshot the solution
  /// @param functional the quantity
  /// @param dual_displacement z of the quantity, without its lift
  template <int dim>
  std::vector<double>
  unresolved_contact(const Snapshot<dim> &snapshot,
                     const Functional    &functional,
                     const LA::Vector    &dual_displacement);

  /// @return the error, exact minus computed, on each active cell because nodes at supports have no
  /// multiplier, (8.8), where the dual solution is not orthogonal to the recovered pressure p*.
  /// Zero for methods that sample at quadrature points. Collective.
  /// @param snapshot the solution
  /// @param functional the quantity
  /// @param dual_displacement z of the quantity, without its lift
  template <int dim>
  std::vector<double>
  dirichlet_contact_errors(const Snapshot<dim> &snapshot,
                           const Functional    &functional,
                           const LA::Vector    &dual_displacement);
} // namespace Signorini
