#include <signorini/solve/line_search.h>

#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The derivative of the energy along u + a du, which grows with a: the energy is convex. It is
    /// minus the residual there,
    ///   phi'(a) = -r.du + a du.K du - [B du].W (p(a) - p(0)) - [S du].W/eps (a S du - p(a) +
    ///   p(0)),
    /// the last term with Nitsche's method (theta = 1) only, and p(a) from the law. K is that of
    /// the linearisation at u.
    class Slope
    {
    public:
      /// Refers to the law and to the inputs.
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
      /// At a, of the point whose first row is i.
      LawVector
      pressure(ContactLaw::Index i, double a) const;

      /// What contact takes off at a, by the points of this rank.
      double
      of_contact(double a) const;

      const ContactLaw  &law;
      const GapOperator &contact;
      const LawInputs   &in;
      LA::Vector         B_du, S_du;
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
      , B_du(contact.zero())
      , S_du(contact.zero())
      , start(-(r * du))
    {
      LA::Vector K_du;
      K_du.reinit(du);
      system.internal_force(K_du, du);
      curvature = K_du * du;
      contact.B_free.vmult(B_du, du);
      if (contact.has_stress())
        contact.S_free.vmult(S_du, du);
    }



    double
    Slope::operator()(const double a) const
    {
      return start + a * curvature -
             Utilities::MPI::sum(of_contact(a), B_du.get_mpi_communicator());
    }



    LawVector
    Slope::pressure(const ContactLaw::Index i, const double a) const
    {
      const unsigned int n     = law.n_components();
      LawInput           there = in.at(i, n);
      for (unsigned int k = 0; k < n; ++k)
        {
          there.gap[k] += a * B_du(i + k);
          there.stress[k] += a * S_du(i + k);
        }
      return law.response(i, there, law.pushes(i, law.trial(i, there))).pressure;
    }



    double
    Slope::of_contact(const double a) const
    {
      const unsigned int n    = law.n_components();
      const IndexSet     rows = B_du.locally_owned_elements();
      double             sum  = 0;
      for (auto row = rows.begin(); row != rows.end();)
        {
          const ContactLaw::Index i = *row;
          const LawVector         p = pressure(i, a);
          for (unsigned int k = 0; k < n; ++k, ++row)
            {
              const double dp = p[k] - in.pressure(i + k), db = B_du(i + k), ds = S_du(i + k);
              sum += contact.weight(i + k) *
                     (dp * db +
                      contact.theta / contact.coefficients.epsilon(i + k) * ds * (a * ds - dp));
            }
        }
      return sum;
    }



    struct Bracket
    {
      double low, high;
    };

    /// Around the step at which the slope is zero, beyond 1 if need be.
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

    /// Where the slope is zero: Newton steps would go astray at the kinks that the law gives it.
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



  bool
  has_energy(const ContactSystem &system)
  {
    return !system.gap_operator().empty() && !system.is_saddle_point() && !system.bulk() &&
           system.is_symmetric();
  }



  double
  best_step(const ContactSystem &system,
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
