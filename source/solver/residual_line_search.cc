// SPDX-License-Identifier: Apache-2.0
#include "solver/step_control.h"

#include <cmath>

namespace Signorini
{
  using namespace dealii;

  double
  norm(const PointVectors &vectors)
  {
    if (vectors.size() == 1)
      return vectors[0].l2_norm();
    double square = 0;
    for (const LA::Vector &component : vectors)
      square += component.norm_sqr();
    return std::sqrt(square);
  }



  namespace
  {
    /// The residual along a step, with the statuses that the law has there.
    class ResidualNorm
    {
    public:
      /// Keeps references to both. Collective.
      ResidualNorm(const LineSearchStart &start, const LA::BlockVector &step)
        : start(start)
        , contact(start.law.gap_operator())
        , step(step)
        , gaps(contact.gaps(start.u))
        , gap_change(contact.zeros())
      {
        for (unsigned int k = 0; k < gap_change.size(); ++k)
          contact.free_rows(k).vmult(gap_change[k], step.block(0));
      }

      /// The norm at step length a, a force. Collective.
      double
      operator()(double a) const;

    private:
      const LineSearchStart &start;
      const GapOperator     &contact;
      const LA::BlockVector &step;
      PointVectors           gaps, gap_change; ///< at the start, and by the full step
    };



    double
    ResidualNorm::operator()(const double a) const
    {
      PointVectors gap = gaps, traction = start.contact.traction;
      for (unsigned int k = 0; k < gap.size(); ++k)
        gap[k].add(a, gap_change[k]);
      if (start.system.is_saddle_point())
        {
          for (unsigned int k = 0; k < gap.size(); ++k)
            traction[k].add(a, step.block(1 + k));
          const PointVectors nothing = contact.zeros();
          const LawInputs    in{gap, nothing, traction, start.contact.internal};
          const PointVectors rows = start.law.residual(in, start.law.status(start.law.trial(in)));
          // The equilibrium is linear in both unknowns.
          return std::hypot((1 - a) * start.r.l2_norm(), norm(rows));
        }
      LA::Vector at = start.u;
      at.add(a, step.block(0));
      const PointVectors stress = contact.stress(at, start.bodies.volumetric_stress());
      const LawInputs    in{gap, stress, traction, start.contact.internal};
      const LA::Vector   status = start.law.status(start.law.trial(in));
      LA::Vector         force  = start.bodies.residual(at);
      force += contact.force(start.law.traction(in, status), stress);
      contact.add_moved_force(force, at);
      start.bodies.constraints().set_zero(force);
      return force.l2_norm();
    }
  } // namespace



  double
  residual_reducing_step(const LineSearchStart &start, const LA::BlockVector &step)
  {
    constexpr double   shorter = 0.7, shortest = 0.24;
    const ResidualNorm residual(start, step);
    const double       first = residual(0);
    double             best = 1, least = residual(1);
    if (least <= first)
      return 1;
    for (double a = shorter; a >= shortest; a *= shorter)
      if (const double here = residual(a); here < least)
        {
          best  = a;
          least = here;
        }
    return best;
  }
} // namespace Signorini
