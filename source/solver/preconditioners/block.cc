// SPDX-License-Identifier: Apache-2.0
#include "solver/linear_solver.h"
#include "solver/preconditioners/factorised.h"

namespace Signorini
{
  using namespace dealii;

  // With an augmentation, a condensed contact system with the stiffness gamma k W at closed points
  // takes the place of K; it is preconditioned by interface multigrid.
  BlockPreconditioner::BlockPreconditioner(const Form                  form,
                                           const LinearSolverSettings &settings,
                                           const ContactSystem        &system,
                                           const Hierarchy            &hierarchy)
    : form(form)
    , augmentation(settings.augmentation)
    , system(system)
    , amg(hierarchy, nullptr)
  {
    if (!system.is_saddle_point())
      return;
    schur = SchurComplement::create(settings, system, amg);
    if (augmentation > 0)
      {
        springs = std::make_unique<NormalContact>(
          NormalContact::springs(system.gap_operator(), augmentation));
        augmented = std::make_unique<ContactSystem>(system.stiffness(), *springs);
        filter    = std::make_unique<InterfaceMultigrid>(*augmented,
                                                      hierarchy,
                                                      settings.direct_solver.value(),
                                                      false);
      }
    if (form == simple)
      {
        inverse_diagonal = system.stiffness().diagonal();
        for (double &d : inverse_diagonal)
          d = 1 / d;
      }
  }



  // The augmentation acts at the closed points of the present active set.
  void
  BlockPreconditioner::update()
  {
    if (!system.is_saddle_point())
      return;
    schur->update();
    if (!augmented)
      return;
    LA::Vector status = system.gap_operator().zero();
    extra             = status;
    for (const auto i : status.locally_owned_elements())
      if (const double A = system.coupling()(i); A != 0)
        {
          status(i) = 1;
          extra(i)  = augmentation / A;
        }
    status.compress(VectorOperation::insert);
    extra.compress(VectorOperation::insert);
    augmented->set_status(status);
    filter->update();
  }



  // S^-1, with the term gamma/(k W) of an augmentation for the pressure (doc/theory, (7.11)).
  void
  BlockPreconditioner::solve_schur(LA::BlockVector &dst, const LA::BlockVector &src) const
  {
    schur->vmult(dst, src);
    if (!augmented)
      return;
    LA::Vector more = src.block(1);
    more.scale(extra);
    dst.block(1) += more;
  }



  void
  BlockPreconditioner::add_coupling(LA::Vector &f, const unsigned int a, const LA::Vector &q) const
  {
    LA::Vector scaled = q;
    scaled.scale(system.coupling());
    system.gap_operator().free_rows(a).Tvmult_add(f, scaled);
  }



  // One application of (7.9), and of (7.10) for SIMPLE.
  void
  BlockPreconditioner::vmult(LA::BlockVector &dst, const LA::BlockVector &src) const
  {
    LA::Vector right = src.block(0);
    if (augmented && form != diagonal)
      {
        // The first row minus B^T A gamma/(k W) times the second, which makes K + B^T gamma k W B
        // of it.
        LA::Vector q = src.block(1);
        q.scale(extra);
        q *= -1;
        add_coupling(right, 0, q);
      }
    if (augmented)
      filter->solve(dst.block(0), right);
    else
      amg.vmult(dst.block(0), right);
    if (!system.is_saddle_point())
      return;
    if (form == diagonal)
      {
        solve_schur(dst, src);
        return;
      }
    // The second block row uses the first result: r_q - (-C B u).
    LA::BlockVector rest = src, found = src;
    found          = 0;
    found.block(0) = dst.block(0);
    system.contact_terms(rest, found);
    rest *= -1;
    rest += src;
    solve_schur(dst, rest);
    for (unsigned int b = 1; b <= system.n_multiplier_blocks(); ++b)
      dst.block(b) *= -1;
    if (form == triangular)
      return;
    // SIMPLE: correct the displacement by diag(K)^-1 B^T A q.
    LA::Vector force;
    force.reinit(dst.block(0));
    for (unsigned int a = 0; a < system.n_multiplier_blocks(); ++a)
      add_coupling(force, a, dst.block(1 + a));
    force.scale(inverse_diagonal);
    dst.block(0) += force;
  }
} // namespace Signorini
