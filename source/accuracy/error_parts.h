// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "accuracy/quantity.h"
#include "solid/elasticity.h"
#include "solver/dual_solution.h"

#include <vector>

namespace Signorini
{
  /// A dual solution without the lift of its quantity.
  struct DualField
  {
    LA::Vector displacement;
    /// Coefficients of the volumetric stress, see DualSolution; empty: no body has one.
    LA::Vector volumetric_stress;
  };

  /// @return the same with ghost values. Collective.
  template <int dim>
  DualField
  with_ghosts(const Elasticity<dim> &elasticity, const DualField &dual);

  /// Estimates of the error of a solution in each active cell; entries of cells of other ranks are
  /// zero.
  struct CellErrors
  {
    /// Square of the energy norm of the error, int e:sigma(e) dV; at finite strain with the
    /// tangent.
    std::vector<double> energy;
    /// [quantity][cell]: the energy product of the errors of the solution and of the dual solution,
    /// (8.6) or (8.20).
    std::vector<std::vector<double>> products;
    /// For each quantity the sum over all cells and ranks of the products of the energy norms of
    /// the errors of solution and dual solution.
    std::vector<double> cauchy_schwarz_bounds;
    /// [quantity][cell]: in bodies and layers of a material that are one cell thick, a share of the
    /// product of the energy norms; with degree 2 of what varies within the cell. Such a cell is
    /// too stiff by a part of it, which no recovered stress tells, as all its samples across the
    /// layer are in that cell.
    std::vector<std::vector<double>> layers;
    /// int sigma:eps dV of the solution, or twice its energy, summed over all ranks.
    double energy_of_solution = 0;
  };

  /// Estimate the errors by recovered stresses: with e the error of the solution and e_z that of a
  /// dual one, J(u) - J(u_h) = a(e, e_z) by Galerkin orthogonality, where the recovered stresses
  /// replace the exact ones, (8.6); for other laws and forms than linear elasticity in
  /// displacements (8.20). Collective.
  /// @param elasticity the model
  /// @param displacement the solution
  /// @param duals one for each quantity
  /// @return the estimates
  template <int dim>
  CellErrors
  cell_errors(const Elasticity<dim>        &elasticity,
              const LA::Vector             &displacement,
              const std::vector<DualField> &duals);

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
    /// [cell]: what the energy, a quantity that is an integral over the bodies, has in addition,
    /// (8.22).
    std::vector<double> of_energy;
  };

  /// @return the contributions of boundaries. Collective.
  /// @param elasticity the model
  /// @param displacement the solution
  /// @param duals one for each quantity
  template <int dim>
  BoundaryErrors
  boundary_errors(const Elasticity<dim>        &elasticity,
                  const LA::Vector             &displacement,
                  const std::vector<DualField> &duals);

  /// @return for each dual field and active cell the error, exact minus computed, because loads
  /// that are formulas of the place are integrated at points: the work of what a rule with more
  /// points adds, (8.23). Collective.
  template <int dim>
  std::vector<std::vector<double>>
  load_errors(const Elasticity<dim> &elasticity, const std::vector<DualField> &duals);

  /// @return the size of the error by contact points that cannot move, such as a corner of the
  /// slave at a support: the support takes their pressure, and its share of the reaction is not
  /// determined. The mean pressure of the pair is assumed there: the sum over these points of area
  /// |B z + dJ/dp| times that pressure. With friction likewise for points that are held along the
  /// surface, with the bound of the tangential traction in place of the pressure. Zero for methods
  /// that sample at quadrature points. Collective.
  /// @param snapshot the solution
  /// @param functional the quantity
  /// @param dual_displacement z of the quantity, without its lift
  template <int dim>
  double
  undetermined_contact(const Snapshot<dim> &snapshot,
                       const Functional    &functional,
                       const LA::Vector    &dual_displacement);

  /// @return the error, exact minus computed, on each active cell because the pressures of
  /// Nitsche's method at the contact points differ from the recovered pressure p*, (8.21), where
  /// the dual solution does not vanish. Collective.
  /// @param snapshot the solution
  /// @param functional the quantity
  /// @param dual_displacement z of the quantity, without its lift
  template <int dim>
  std::vector<double>
  pointwise_contact_errors(const Snapshot<dim> &snapshot,
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

  /// @return the error, exact minus computed, on each active cell because compliant interfaces have
  /// their law at nodes, not at each point of the surface, (8.25). Zero for rigid interfaces, and
  /// for methods that sample at quadrature points. Collective.
  /// @param snapshot the solution
  /// @param functional the quantity
  /// @param dual_displacement z of the quantity, without its lift
  template <int dim>
  std::vector<double>
  compliance_errors(const Snapshot<dim> &snapshot,
                    const Functional    &functional,
                    const LA::Vector    &dual_displacement);

  /// @return the error, exact minus computed, on each active cell because nodes at supports have no
  /// multiplier, (8.8), where the dual solution is not orthogonal to the recovered pressure p*.
  /// Zero for methods that sample at quadrature points, and for compliant interfaces, whose errors
  /// contain it. Collective.
  /// @param snapshot the solution
  /// @param functional the quantity
  /// @param dual_displacement z of the quantity, without its lift
  template <int dim>
  std::vector<double>
  dirichlet_contact_errors(const Snapshot<dim> &snapshot,
                           const Functional    &functional,
                           const LA::Vector    &dual_displacement);
} // namespace Signorini
