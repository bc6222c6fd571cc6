#include <signorini/solve/linear_solver.h>
#include <signorini/solve/preconditioners/block.h>

namespace Signorini
{
  using namespace dealii;

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
        filter    = std::make_unique<ContactFilter>(*augmented,
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



  void
  BlockPreconditioner::update()
  {
    if (!system.is_saddle_point())
      return;
    schur->update();
    if (!augmented)
      return;
    LA::Vector active = system.gap_operator().zero();
    extra             = active;
    for (const auto i : active.locally_owned_elements())
      if (const double A = system.coupling()(i); A != 0)
        {
          active(i) = 1;
          extra(i)  = augmentation / A;
        }
    active.compress(VectorOperation::insert);
    extra.compress(VectorOperation::insert);
    augmented->set_active(active);
    filter->update();
  }



  void
  BlockPreconditioner::solve_schur(LA::Vector &dst, const LA::Vector &src) const
  {
    schur->vmult(dst, src);
    if (!augmented)
      return;
    LA::Vector more = src;
    more.scale(extra);
    dst += more;
  }



  void
  BlockPreconditioner::add_coupling(LA::Vector &f, const LA::Vector &q) const
  {
    LA::Vector scaled = q;
    scaled.scale(system.coupling());
    system.gap_operator().B_free.Tvmult_add(f, scaled);
  }



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
        add_coupling(right, q);
      }
    if (augmented)
      filter->solve(dst.block(0), right);
    else
      amg.vmult(dst.block(0), right);
    if (!system.is_saddle_point())
      return;
    if (form == diagonal)
      {
        solve_schur(dst.block(1), src.block(1));
        return;
      }
    LA::Vector rest = system.gap_operator().zero();
    system.gap_operator().B_free.vmult(rest, dst.block(0));
    rest.scale(system.coupling());
    rest += src.block(1);
    solve_schur(dst.block(1), rest);
    dst.block(1) *= -1;
    if (form == triangular)
      return;
    LA::Vector force;
    force.reinit(dst.block(0));
    add_coupling(force, dst.block(1));
    force.scale(inverse_diagonal);
    dst.block(0) += force;
  }
} // namespace Signorini
