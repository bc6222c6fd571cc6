// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/laws/normal_contact.h"
#include "solver/interface_solver.h"
#include "solver/preconditioner.h"
#include "solver/preconditioners/interface_multigrid.h"
#include "solver/preconditioners/schur_complement.h"

namespace Signorini
{
  /// Preconditioners of saddle points from an approximation of K^-1 and one of the Schur complement
  /// S (Benzi, Golub, Liesen, Acta Numerica 14 (2005) 1-137, chapter 10; doc/theory, 7.5):
  ///
  ///   diagonal    diag(K, S), for MINRES;
  ///   triangular  [K 0; -C B -S]: the second row uses the result of the first;
  ///   simple      in addition, the displacement is corrected by the multipliers through diag(K)^-1
  ///               (Patankar, Spalding, Int. J. Heat Mass Transfer 15 (1972) 1787-1806).
  ///
  /// K^-1 is a multigrid cycle. With an augmentation gamma, K is replaced by K + B^T gamma k W B,
  /// which is solved by interface multigrid, and S^-1 gains gamma/(k W) for the pressure: the
  /// larger gamma, the better is this diagonal alone (Golub, Greif, SIAM J. Sci. Comput. 24 (2003)
  /// 2076-2092).
  ///
  /// On condensed systems all three are AMG(K) alone.
  class BlockPreconditioner : public Preconditioner
  {
  public:
    enum Form
    {
      diagonal,
      triangular,
      simple
    };

    BlockPreconditioner(Form                        form,
                        const LinearSolverSettings &settings,
                        const ContactSystem        &system,
                        const Hierarchy            &hierarchy);

    void
    update() override;

    void
    vmult(LA::BlockVector &dst, const LA::BlockVector &src) const override;

    unsigned int
    multigrid_cycles() const override
    {
      return amg.multigrid_cycles() + (filter ? filter->multigrid_cycles() : 0);
    }

    bool
    is_positive_definite() const override
    {
      return form == diagonal && (!schur || schur->is_linear());
    }

  private:
    /// dst = S^-1 src in the blocks of the multipliers.
    void
    solve_schur(LA::BlockVector &dst, const LA::BlockVector &src) const;

    /// f += B_a^T A q
    void
    add_coupling(LA::Vector &f, unsigned int a, const LA::Vector &q) const;

    const Form           form;
    const double         augmentation;
    const ContactSystem &system;
    const AMG            amg;
    LA::Vector           inverse_diagonal; ///< of K

    std::unique_ptr<SchurComplement>    schur;
    std::unique_ptr<NormalContact>      springs;
    std::unique_ptr<ContactSystem>      augmented;
    std::unique_ptr<InterfaceMultigrid> filter;
    LA::Vector                          extra; ///< gamma/(k W) on closed points, of the pressure
  };

  /// Factorisation of the whole system: for small problems and as a reference.
  class Direct : public Preconditioner
  {
  public:
    Direct(const ContactSystem &system, LA::DirectLibrary direct_solver);

    void
    update() override;

    void
    vmult(LA::BlockVector &dst, const LA::BlockVector &src) const override;

    bool
    is_positive_definite() const override
    {
      return false;
    }

    /// Springs against unconstrained rigid-body modes are in the factors, but not in the system;
    /// how forces change as surfaces move is in the system, but not in the factors.
    bool
    is_exact() const override
    {
      return system.unconstrained_modes().empty() && system.gap_operator().at_rest();
    }

    bool
    preserves_constraints() const override
    {
      return true;
    }

    void
    start(LA::BlockVector &x, const LA::BlockVector &rhs) const override;

  private:
    const ContactSystem &system;
    InterfaceSolver      all;
  };
} // namespace Signorini
