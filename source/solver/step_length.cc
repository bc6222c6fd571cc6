// SPDX-License-Identifier: Apache-2.0
#include "base/interruption.h"
#include "solver/step_control.h"

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The derivative of the energy along u + a du at finite strain: minus the residual in the
    /// direction du.
    class Resistance
    {
    public:
      /// Keeps references to both.
      Resistance(const LineSearchStart &start, const LA::BlockVector &step)
        : start(start)
        , contact(start.law.gap_operator())
        , step(step)
        , du(step.block(0))
      {}

      /// The derivative at step length a; costs one evaluation of the residual. Collective.
      double
      operator()(double a) const;

      /// The derivative at step length 0, from the residual at hand. Collective.
      double
      at_start() const;

    private:
      /// The tractions of the law at u; those that are independent unknowns take the values of the
      /// augmented Lagrangian, max(0, p - c g) and the projection of t - c s.
      PointVectors
      traction(const LA::Vector &u, const PointVectors &unknown) const;

      /// The stress of the bodies at the points.
      PointVectors
      stress(const LA::Vector &u) const
      {
        return contact.stress(u, start.bodies.volumetric_stress());
      }

      const LineSearchStart &start;
      const GapOperator     &contact;
      const LA::BlockVector &step;
      const LA::Vector      &du;
    };



    // The resistance (4.12): one residual of the bodies, contact forces with the tractions of the
    // law at that point, and the geometric term.
    double
    Resistance::operator()(const double a) const
    {
      check_for_interruption();
      LA::Vector at = start.u;
      at.add(a, du);
      LA::Vector force = start.bodies.residual(at);
      if (!contact.empty())
        {
          PointVectors p = start.contact.traction;
          for (unsigned int k = 0; k < p.size() && start.system.is_saddle_point(); ++k)
            p[k].add(a, step.block(1 + k));
          force += contact.force(traction(at, p), stress(at));
          contact.add_moved_force(force, at);
        }
      start.bodies.constraints().set_zero(force);
      return -(force * du);
    }



    // From the residual at hand. Where pressures are unknowns, tractions of the merit function
    // replace them; with a volumetric stress the residual has the full step of m, whose work is
    // removed.
    double
    Resistance::at_start() const
    {
      double result = -(start.r * du);
      if (start.system.is_saddle_point())
        {
          PointVectors more = traction(start.u, start.contact.traction);
          for (unsigned int k = 0; k < more.size(); ++k)
            more[k] -= start.contact.traction[k];
          LA::Vector force = contact.force(more, stress(start.u));
          start.bodies.constraints().set_zero(force);
          result -= force * du;
        }
      if (start.system.volumetric())
        {
          const LA::Vector &m      = step.block(start.system.volumetric_block());
          LA::Vector        volume = m;
          start.system.volumetric()->B.vmult(volume, du);
          result += volume * m;
        }
      return result;
    }



    PointVectors
    Resistance::traction(const LA::Vector &u, const PointVectors &unknown) const
    {
      const PointVectors gaps = contact.gaps(u), s = stress(u);
      const LawInputs    in{gaps, s, unknown, start.contact.internal};
      const PointVectors trial  = start.law.trial(in);
      const LA::Vector   status = start.law.status(trial);
      PointVectors       result = start.law.traction(in, status);
      if (!start.system.is_saddle_point())
        return result;
      for (const auto i : status.locally_owned_elements())
        {
          result[0](i) = is_closed(status(i)) ? trial[0](i) : 0.;
          if (result.size() == 1)
            continue;
          // The residual of the constraint is (t - Pi)/epsilon with the projection Pi.
          const LawVector d = start.law.response(i, in.at(i), status_of(status(i))).residual;
          for (unsigned int a = 1; a < result.size(); ++a)
            result[a](i) = result[a](i) - start.law.residual_stiffness(i) * d[a];
        }
      for (LA::Vector &component : result)
        component.compress(VectorOperation::insert);
      return result;
    }
  } // namespace



  // Accept the longest admissible step unless the resistance there exceeds 80 % of that at the
  // start; otherwise find a step length between (doc/theory, 4.7). At most eight residuals; if none
  // satisfies the criterion, the last length with negative slope is taken.
  double
  energy_descending_step(const LineSearchStart &start,
                         const LA::BlockVector &step,
                         const double           longest)
  {
    // Share of the slope at the start that is accepted.
    constexpr double       enough = 0.8;
    constexpr unsigned int most   = 8;
    const Resistance       slope(start, step);
    const double           first = -slope.at_start(), last = slope(longest);
    if (!(first > 0) || last <= enough * first)
      return longest;
    double low = 0, high = longest;
    double at_low = -first, at_high = last;
    // First trial: the stretch due to a linearised rotation grows with the square of the step
    // length, its forces along the step with the third power.
    double a = longest * std::cbrt(first / (first + last));
    // Regula falsi on the slope, safeguarded to stay inside of the bracket. A slope reduced to 80 %
    // suffices: the aim is a decrease of the energy, not its exact minimum.
    for (unsigned int i = 0; i < most; ++i)
      {
        const double here = slope(a);
        if (std::abs(here) <= enough * first)
          return a;
        (here < 0 ? low : high)       = a;
        (here < 0 ? at_low : at_high) = here;
        const double share            = -at_low / (at_high - at_low);
        a                             = low + std::clamp(share, 0.1, 0.9) * (high - low);
      }
    return low > 0 ? low : a;
  }
} // namespace Signorini
