#include <signorini/solve/line_search.h>

#include <cmath>

namespace Signorini
{
  using namespace dealii;

  bool
  has_energy(const ContactSystem &system)
  {
    return !system.gap_operator().empty() && !system.is_saddle_point() && system.is_symmetric();
  }



  double
  best_step(const ContactSystem &system,
            const ContactLaw    &law,
            const LA::Vector    &r,
            const LawInputs     &in,
            const LA::Vector    &du)
  {
    const GapOperator &contact = law.gap_operator();
    // The energy along u + a du is convex; its derivative is minus the residual there:
    //   phi'(a) = -r.du + a du.K du - [B du].W (p(a) - p(0)) - [S du].W/eps (a S du - p(a) + p(0)),
    // the last term with Nitsche's method (theta = 1) only, and p(a) from the law. K is that of the
    // linearisation at u.
    LA::Vector K_du, B_du = contact.zero();
    K_du.reinit(du);
    system.internal_force(K_du, du);
    contact.B_free.vmult(B_du, du);
    LA::Vector S_du = contact.zero();
    if (contact.has_stress())
      contact.S_free.vmult(S_du, du);
    const double       slope = -(r * du), curvature = K_du * du;
    const double       theta      = contact.theta;
    const MPI_Comm     comm       = du.get_mpi_communicator();
    const IndexSet     rows       = B_du.locally_owned_elements();
    const unsigned int n          = law.n_components();
    const auto         derivative = [&](const double a) {
      double sum = 0;
      for (auto row = rows.begin(); row != rows.end();)
        {
          const auto i     = *row;
          LawInput   there = in.at(i, n);
          for (unsigned int k = 0; k < n; ++k)
            {
              there.gap[k] += a * B_du(i + k);
              there.stress[k] += a * S_du(i + k);
            }
          const bool      pushes = law.pushes(i, law.trial(i, there));
          const LawVector p      = law.response(i, there, pushes).pressure;
          for (unsigned int k = 0; k < n; ++k, ++row)
            {
              const double dp = p[k] - in.pressure(i + k), db = B_du(i + k), ds = S_du(i + k);
              sum += contact.weight(i + k) *
                     (dp * db + theta / contact.coefficients.epsilon(i + k) * ds * (a * ds - dp));
            }
        }
      return slope + a * curvature - Utilities::MPI::sum(sum, comm);
    };
    if (std::abs(derivative(1)) <= 0.1 * std::abs(slope))
      return 1;
    double low = 0, high = 1;
    while (derivative(high) < 0 && high < 1e3)
      {
        low = high;
        high *= 2;
      }
    for (unsigned int i = 0; i < 60 && high - low > 1e-10 * high; ++i)
      {
        const double middle                   = (low + high) / 2;
        (derivative(middle) < 0 ? low : high) = middle;
      }
    return (low + high) / 2;
  }
} // namespace Signorini
