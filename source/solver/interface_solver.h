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
  /// Nonzero at the degrees of freedom that active contact points touch.
  LA::Vector
  active_interface_dofs(const ContactSystem &system);

  /// At those along which a node moves where the gaps of these points open. A surface that has
  /// moved has a normal with all components, but to let its nodes move along the largest one is
  /// enough for any gap, and the others make the zone thrice as large.
  /// @param n_components of a node
  LA::Vector
  dominant_interface_dofs(const ContactSystem &system, unsigned int n_components);

  /// At those that any contact points touch.
  LA::Vector
  potential_interface_dofs(const ContactSystem &system);

  /// Exact solution of a ContactSystem restricted to a zone: some of the degrees of freedom, and
  /// all multipliers. With the degrees of freedom that contact touches it costs a surface, with all
  /// of them it is a direct solver. Forces of contact that turn join what multipliers keep apart:
  /// factors that know of them take several times as long, and spare CG iterations where pressures
  /// are large beside moduli.
  class InterfaceSolver
  {
  public:
    /// @param marker nonzero at the degrees of freedom of the zone
    /// @param with_geometric with forces of contact that turn, if those of the system do
    InterfaceSolver(const ContactSystem &system,
                    const LA::Vector    &marker,
                    LA::DirectLibrary    direct_library,
                    bool                 with_geometric = true);

    /// Factorise for the present system. Throws SolverFailure if the zone is singular.
    void
    update();

    /// x += R^T (R A R^T)^-1 R r with the restriction R to the zone.
    void
    add_correction(LA::BlockVector &x, const LA::BlockVector &r) const;

    /// x += R^T (R A R^T)^-1 R (r - A x), with that A: afterwards the residual of x vanishes on the
    /// zone. Only the rows of the zone are evaluated.
    void
    correct(LA::BlockVector &x, const LA::BlockVector &r) const;

    dealii::types::global_dof_index
    size() const
    {
      return owned.size();
    }

  private:
    class Entries;

    void
    collect(Entries &entries) const;
    void
    collect_contact_stiffness(Entries &entries) const;
    void
    collect_multipliers(Entries &entries) const;
    void
    collect_geometric(Entries &entries) const;

    /// Calls act(block of the system's vectors, number of the point on this rank) in the order of
    /// the zone: point by point, its components one after the other.
    template <typename Action>
    void
    for_each_multiplier(const Action &act) const;

    /// x += R^T (R A R^T)^-1 right
    void
    add_solution(LA::BlockVector &x) const;

    const ContactSystem        &system;
    const LA::SparseMatrix     &K; ///< its rows of the zone
    const LA::ColumnExchange    columns_of_K;
    mutable std::vector<double> x_of_K; ///< a vector there
    const LA::DirectLibrary     library;
    const bool                  with_geometric;

    /// The owned degrees of freedom of the zone: number among those that this rank owns, zone
    /// index. The zone's owned indices are these, then the multipliers of this rank.
    std::vector<std::pair<unsigned int, dealii::types::global_dof_index>> dofs;
    dealii::types::global_dof_index                                       first_row =
      0; ///< zone index of the first multiplier of this rank
    dealii::IndexSet    owned;
    LA::Vector          number;                   ///< zone index of each degree of freedom, or -1
    std::vector<double> number_in_K, number_in_B; ///< that of each local column

    LA::SparseMatrix        matrix;
    mutable LA::Vector      left, right;
    mutable LA::BlockVector contact_terms;
    LA::DirectSolver        solver; ///< of matrix
  };
} // namespace Signorini
