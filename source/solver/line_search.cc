// SPDX-License-Identifier: Apache-2.0
#include "solver/step_control.h"

#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The derivative phi'(a) of the energy along u + a du. It is monotone, since the energy is
    /// convex, and equals minus the residual in the direction du,
    ///
    ///   phi'(a) = -r.du + a du.K du - [B du].W (p(a) - p(0)) - [S du].W/eps (a S du - p(a) +
    ///   p(0)),
    ///
    /// with p(a) from the contact law; the last term belongs to Nitsche's method (theta = 1). K is
    /// the linearisation at u.
    class Slope
    {
    public:
      /// Keeps references to the law and to the inputs. Collective.
      Slope(const ContactSystem &system,
            const ContactLaw    &law,
            const LA::Vector    &r,
            const LawInputs     &in,
            const LA::Vector    &du);

      /// phi'(a). Collective.
      double
      operator()(double a) const;

      /// phi'(0).
      double
      at_start() const
      {
        return start;
      }

    private:
      /// The traction at point i for the step length a.
      LawVector
      traction(ContactLaw::Index i, double a) const;

      /// The contact terms of phi'(a), summed over the points of this rank; to be subtracted.
      double
      of_contact(double a) const;

      const ContactLaw  &law;
      const GapOperator &contact;
      const LawInputs   &in;
      PointVectors       B_du, S_du;
      double             start, curvature; ///< phi'(0), and du.K du
    };



    Slope::Slope(const ContactSystem &system,
                 const ContactLaw    &law,
                 const LA::Vector    &r,
                 const LawInputs     &in,
                 const LA::Vector    &du)
      : law(law)
      , contact(law.gap_operator())
      , in(in)
      , B_du(contact.zeros())
      , S_du(contact.zeros())
      , start(-(r * du))
    {
      LA::Vector K_du;
      K_du.reinit(du);
      system.internal_force(K_du, du);
      curvature = K_du * du;
      for (unsigned int k = 0; k < B_du.size(); ++k)
        {
          contact.free_rows(k).vmult(B_du[k], du);
          if (contact.has_stress())
            contact.S_free[k].vmult(S_du[k], du);
        }
    }



    // One reduction; K du and B du have been computed once.
    double
    Slope::operator()(const double a) const
    {
      return start + a * curvature -
             Utilities::MPI::sum(of_contact(a), contact.weight.get_mpi_communicator());
    }



    LawVector
    Slope::traction(const ContactLaw::Index i, const double a) const
    {
      LawInput there = in.at(i);
      for (unsigned int k = 0; k < B_du.size(); ++k)
        {
          there.gap[k] += a * B_du[k](i);
          there.stress[k] += a * S_du[k](i);
        }
      return law.response(i, there, law.status(i, law.trial(i, there))).traction;
    }



    // Work of the change of tractions on the change of gaps, with the term of theta in (4.11).
    double
    Slope::of_contact(const double a) const
    {
      double sum = 0;
      for (const auto i : contact.weight.locally_owned_elements())
        {
          const LawVector p = traction(i, a);
          for (unsigned int k = 0; k < B_du.size(); ++k)
            {
              const double dp = p[k] - in.traction[k](i), ds = S_du[k](i);
              sum += contact.weight(i) *
                     (dp * B_du[k](i) +
                      contact.theta / contact.coefficients.epsilon(i) * ds * (a * ds - dp));
            }
        }
      return sum;
    }



    /// An interval of step lengths.
    struct Bracket
    {
      double low, high;
    };

    /// An interval that contains the zero of the slope, by doubling the step length from 1.
    Bracket
    bracket(const Slope &slope)
    {
      constexpr double longest = 1e3;
      Bracket          result{0, 1};
      while (slope(result.high) < 0 && result.high < longest)
        {
          result.low = result.high;
          result.high *= 2;
        }
      return result;
    }

    /// The zero of the slope, by bisection, which the kinks of the contact law do not disturb. Ends
    /// at a relative width of 1e-10.
    double
    bisect(const Slope &slope, Bracket in)
    {
      for (unsigned int i = 0; i < 60 && in.high - in.low > 1e-10 * in.high; ++i)
        {
          const double middle                    = (in.low + in.high) / 2;
          (slope(middle) < 0 ? in.low : in.high) = middle;
        }
      return (in.low + in.high) / 2;
    }
  } // namespace



  // The energy (4.10) exists for condensed symmetric systems without volumetric stress.
  bool
  has_energy(const ContactSystem &system)
  {
    return !system.gap_operator().empty() && !system.is_saddle_point() && !system.volumetric() &&
           system.is_symmetric();
  }



  double
  energy_minimising_step(const ContactSystem &system,
                         const ContactLaw    &law,
                         const LA::Vector    &r,
                         const LawInputs     &in,
                         const LA::Vector    &du)
  {
    const Slope slope(system, law, r, in, du);
    if (std::abs(slope(1)) <= 0.1 * std::abs(slope.at_start()))
      return 1;
    return bisect(slope, bracket(slope));
  }
} // namespace Signorini
