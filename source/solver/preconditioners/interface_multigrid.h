// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solver/interface_solver.h"
#include "solver/preconditioner.h"
#include "solver/preconditioners/amg.h"

namespace Signorini
{
  /// F-V-F: an exact solve on the degrees of freedom that contact touches, and on all multipliers
  /// (F), one cycle of the multigrid method for K and contact springs of a few E/h (V), F again.
  /// The hierarchy is that of K; what is stiffer, or the constraints in a saddle point system, is
  /// seen by F only, so that the iteration count depends neither on the penalty nor on the size of
  /// the mesh.
  ///
  /// After F the residual vanishes on the zone. It does so for the start value, hence for all
  /// residuals of a Krylov method, for which the first F is void: what remains is one multigrid
  /// cycle and one F an application. Springs against unconstrained rigid-body modes, which F has
  /// and the system has not, leave a little on the zone, on meshes of a few cells not so little;
  /// the volumetric stress of mixed bodies leaves much: then, the first F is made too.
  ///
  /// On saddle points F keeps the constraints, A B du = A g from the start on: all that CG sees is
  /// the energy on their null space, where F-V-F is symmetric and positive definite (a constraint
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

    /// F-V-F as a whole, for any right-hand side of a condensed system.
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
    /// F-V-F, and V-F for what has no part on the zone.
    void
    correct_first(LA::BlockVector &dst, const LA::BlockVector &src) const;
    void
    cycle_and_correct(LA::BlockVector &dst, const LA::BlockVector &src) const;

    const ContactSystem             &system;
    AMG                              amg;
    const unsigned int               n_components; ///< of a node
    const LA::DirectLibrary          direct_solver;
    const bool                       interface_includes_geometric;
    std::unique_ptr<InterfaceSolver> interface; ///< what active contact touches
  };
} // namespace Signorini
