// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solver/interface_solver.h"
#include "solver/preconditioner.h"
#include "solver/preconditioners/amg.h"

namespace Signorini
{
  /// Multigrid with exact interface correction (multiplicative Schwarz; doc/theory, 7.3), F-V-F: an
  /// exact solve on the active interface and all multipliers (F), one cycle of the multigrid method
  /// for K with a contact stiffness of a few E/h (V), and F again. The hierarchy is that of K.
  /// Stiffer penalties and the constraints of a saddle point system enter through F only, so that
  /// the number of iterations depends neither on the penalty nor on the mesh size.
  ///
  /// After F the residual vanishes on the interface. It does so for the start value, hence for all
  /// residuals of a Krylov method, for which the first F has no effect: one multigrid cycle and one
  /// F for each application remain. Exceptions: the stabilisation of unconstrained modes, which F
  /// contains and the system does not, leaves a small residual on the interface (not so small on
  /// meshes of a few cells), and the volumetric stress leaves a large one; then the first F is
  /// applied too.
  ///
  /// On saddle points F preserves the constraints, A B du = A g from the start on: the iterates of
  /// CG stay in their null space, where F-V-F is symmetric and positive definite (a constraint
  /// preconditioner: Gould, Hribar, Nocedal, SIAM J. Sci. Comput. 23 (2001) 1376-1395).
  class InterfaceMultigrid : public Preconditioner
  {
  public:
    /// @param interface_includes_geometric see InterfaceSolver
    InterfaceMultigrid(const ContactSystem &system,
                       const Hierarchy     &hierarchy,
                       LA::DirectLibrary    direct_solver,
                       bool                 interface_includes_geometric);

    void
    update() override;

    void
    start(LA::BlockVector &x, const LA::BlockVector &rhs) const override;

    /// Apply F-V-F to any right-hand side of a condensed system.
    void
    solve(LA::Vector &dst, const LA::Vector &src) const;

    void
    vmult(LA::BlockVector &dst, const LA::BlockVector &src) const override;

    unsigned int
    multigrid_cycles() const override
    {
      return amg.multigrid_cycles();
    }

    bool
    is_positive_definite() const override
    {
      return false;
    }

    bool
    preserves_constraints() const override
    {
      return true;
    }

  private:
    /// F-V-F, or V-F if the residual vanishes on the interface.
    void
    correct_first(LA::BlockVector &dst, const LA::BlockVector &src) const;
    void
    cycle_and_correct(LA::BlockVector &dst, const LA::BlockVector &src) const;

    const ContactSystem             &system;
    AMG                              amg;
    const unsigned int               n_components; ///< of a node
    const LA::DirectLibrary          direct_solver;
    const bool                       interface_includes_geometric;
    std::unique_ptr<InterfaceSolver> interface; ///< exact solver on the active interface
  };
} // namespace Signorini
