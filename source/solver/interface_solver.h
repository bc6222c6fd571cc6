// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "linear_algebra/columns.h"
#include "linear_algebra/direct_solver.h"
#include "solver/contact_system.h"
#include <signorini/solver/linear_solver_settings.h>

#include <string>
#include <utility>
#include <vector>

namespace Signorini
{
  /// Marker of the active interface: nonzero at the degrees of freedom in rows of active contact
  /// points.
  LA::Vector
  active_interface_dofs(const ContactSystem &system);

  /// Marker of the active interface restricted to one component for each node, that along which the
  /// gaps of its points change most. In a displaced configuration normals have all components; but
  /// the largest one suffices to close any gap, and the others would make the interface solve three
  /// times as large.
  /// @param n_components of a node
  LA::Vector
  dominant_interface_dofs(const ContactSystem &system, unsigned int n_components);

  /// Marker of the potential interface: nonzero at the degrees of freedom in rows of any contact
  /// points.
  LA::Vector
  potential_interface_dofs(const ContactSystem &system);

  /// Exact solution of a ContactSystem restricted to a subset of its degrees of freedom and all
  /// multipliers: a local solve as in Schwarz methods. With the degrees of freedom of the active
  /// interface its cost is that of a surface problem; with all degrees of freedom it is a direct
  /// solver. The contact geometric stiffness couples what multipliers keep apart: a factorisation
  /// that includes it takes several times as long, and saves CG iterations where pressures are
  /// large compared to moduli.
  class InterfaceSolver
  {
  public:
    /// Keeps a reference to the system.
    /// @param marker nonzero at the degrees of freedom to be included
    /// @param with_geometric include the contact geometric stiffness if the system does
    InterfaceSolver(const ContactSystem &system,
                    const LA::Vector    &marker,
                    LA::DirectLibrary    direct_library,
                    bool                 with_geometric = true);

    /// Factorise for the present system. Throws SolverFailure if the restricted matrix is singular.
    /// Collective.
    void
    update();

    /// x += R^T (R A R^T)^-1 R r with the restriction R to the included unknowns. Collective.
    void
    add_correction(LA::BlockVector &x, const LA::BlockVector &r) const;

    /// x += R^T (R A R^T)^-1 R (r - A x): afterwards the residual of x vanishes on the included
    /// unknowns. Only their rows are evaluated. Collective.
    void
    correct(LA::BlockVector &x, const LA::BlockVector &r) const;

    /// The number of unknowns of the restricted system, over all ranks.
    dealii::types::global_dof_index
    size() const
    {
      return owned.size();
    }

  private:
    class Entries;

    /// Collect the entries of the restricted matrix on this rank.
    void
    collect(Entries &entries) const;
    /// Collect the entries of the contact stiffness (condensed form).
    void
    collect_contact_stiffness(Entries &entries) const;
    /// Collect the entries of the multipliers (saddle point form).
    void
    collect_multipliers(Entries &entries) const;
    /// Collect the entries of the contact geometric stiffness.
    void
    collect_geometric(Entries &entries) const;

    /// Call act(block of the system's vectors, local number of the point) for the multipliers of
    /// this rank in the order of their indices: point by point, all components of a point one after
    /// the other.
    template <typename Action>
    void
    for_each_multiplier(const Action &act) const;

    /// x += R^T (R A R^T)^-1 right
    void
    add_solution(LA::BlockVector &x) const;

    const ContactSystem        &system;
    const LA::SparseMatrix     &K; ///< the rows of the included degrees of freedom
    const LA::ColumnExchange    columns_of_K;
    mutable std::vector<double> x_of_K; ///< workspace: a vector on columns_of_K
    const LA::DirectLibrary     library;
    const bool                  with_geometric;

    /// The included degrees of freedom of this rank: (local number, index in the restricted
    /// system). The owned indices of the restricted system are these, then the multipliers of this
    /// rank.
    std::vector<std::pair<unsigned int, dealii::types::global_dof_index>> dofs;
    dealii::types::global_dof_index first_row = 0; ///< index of the first multiplier of this rank
    dealii::IndexSet                owned;
    LA::Vector number; ///< index of each degree of freedom in the restricted system, or -1
    /// Index of each local column in the restricted system, or -1.
    std::vector<double> number_in_K, number_in_B;

    LA::SparseMatrix        matrix;
    mutable LA::Vector      left, right;
    mutable LA::BlockVector contact_terms;
    LA::DirectSolver        solver; ///< of matrix
  };
} // namespace Signorini
