#include <signorini/interruption/interruption.h>
#include <signorini/solve/step_length.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The derivative of the energy along u + a du where bodies deform by any amount.
    class Resistance
    {
    public:
      /// Refers to both.
      Resistance(const StepStart &start, const LA::BlockVector &step)
        : start(start)
        , contact(start.law.gap_operator())
        , step(step)
        , du(step.block(0))
      {}

      /// At a. Collective, as the next one.
      double
      operator()(double a) const;

      /// At 0, by what is known there.
      double
      at_start() const;

    private:
      /// What the law says; unknown ones as of the augmented Lagrangian, (p - c g)+.
      LA::Vector
      pressure(const LawInputs &in) const;

      const StepStart       &start;
      const GapOperator     &contact;
      const LA::BlockVector &step;
      const LA::Vector      &du;
    };



    double
    Resistance::operator()(const double a) const
    {
      look_for_interruption();
      LA::Vector at = start.u;
      at.add(a, du);
      LA::Vector force = start.bodies.residual(at);
      if (!contact.empty())
        {
          LA::Vector p = start.p;
          if (start.system.is_saddle_point())
            p.add(a, step.block(1));
          const LA::Vector gap = contact.gap(at),
                           s   = contact.stress(at, start.bodies.bulk_stress());
          force += contact.force(pressure({gap, s, p}), s);
          contact.add_moved_force(force, at);
        }
      start.bodies.constraints().set_zero(force);
      return -(force * du);
    }



    double
    Resistance::at_start() const
    {
      double result = -(start.r * du);
      if (start.system.is_saddle_point())
        {
          const LA::Vector gap = contact.gap(start.u),
                           s   = contact.stress(start.u, start.bodies.bulk_stress());
          LA::Vector more      = pressure({gap, s, start.p});
          more -= start.p;
          LA::Vector force = contact.force(more, s);
          start.bodies.constraints().set_zero(force);
          result -= force * du;
        }
      if (start.system.bulk())
        {
          LA::Vector volume = step.block(2);
          start.system.bulk()->B.vmult(volume, du);
          result += volume * step.block(2);
        }
      return result;
    }



    LA::Vector
    Resistance::pressure(const LawInputs &in) const
    {
      const LA::Vector trial = start.law.trial(in), pushes = start.law.pushes(trial);
      LA::Vector       result = start.law.pressure(in, pushes);
      if (!start.system.is_saddle_point())
        return result;
      const IndexSet     rows = result.locally_owned_elements();
      const unsigned int n    = start.law.n_components();
      for (auto row = rows.begin(); row != rows.end();)
        {
          result(*row) = pushes(*row) > 0 ? trial(*row) : 0.;
          for (unsigned int k = 0; k < n; ++k)
            ++row;
        }
      result.compress(VectorOperation::insert);
      return result;
    }
  } // namespace



  double
  descending_step(const StepStart &start, const LA::BlockVector &step, const double longest)
  {
    constexpr double       enough = 0.8; // of the slope at the start
    constexpr unsigned int most   = 8;
    const Resistance       slope(start, step);
    const double           first = -slope.at_start(), last = slope(longest);
    if (!(first > 0) || last <= enough * first)
      return longest;
    double low = 0, high = longest;
    double at_low = -first, at_high = last;
    // Stretches beside a turn resist with the third power.
    double a = longest * std::cbrt(first / (first + last));
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
