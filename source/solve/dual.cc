#include <signorini/solve/newton.h>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// What dependent pressures do: of_pressure times their derivative by gap or stress, on rows.
    template <typename Derivative>
    LA::Vector
    through_law(const ContactLaw &law,
                const LA::Vector &active,
                const LA::Vector &of_pressure,
                const Derivative &derivative)
    {
      const unsigned int n      = law.n_components();
      LA::Vector         result = law.gap_operator().zero();
      const IndexSet     rows   = result.locally_owned_elements();
      for (auto row = rows.begin(); row != rows.end();)
        {
          const auto      first = *row;
          const LawMatrix by    = derivative(law.response(first, {}, active(first) > 0));
          for (unsigned int b = 0; b < n; ++b, ++row)
            {
              double sum = 0;
              for (unsigned int a = 0; a < n; ++a)
                sum += of_pressure(first + a) * by[a][b];
              result(*row) = sum;
            }
        }
      result.compress(VectorOperation::insert);
      return result;
    }

    LA::Vector
    by_gap(const ContactLaw &law, const LA::Vector &active, const LA::Vector &of_pressure)
    {
      return through_law(law, active, of_pressure, [](const LawResponse &response) {
        return response.dp_dg;
      });
    }

    LA::Vector
    by_stress(const ContactLaw &law, const LA::Vector &active, const LA::Vector &of_pressure)
    {
      return through_law(law, active, of_pressure, [](const LawResponse &response) {
        return response.dp_ds;
      });
    }
  } // namespace



  DualSolution
  Newton::dual(const LA::Vector &u,
               const LA::Vector &p,
               const LA::Vector &active,
               const LA::Vector &of_displacement,
               const LA::Vector &of_pressure,
               const double      reduction)
  {
    linearise(u);
    LA::BlockVector rhs = system.zero(), left = system.zero();
    rhs.block(0)         = of_displacement;
    const LA::Vector gap = contact.gap(u), s = contact.stress(u, bodies.bulk_stress());
    left.block(0) = balance.residual(u, p, s, active);
    if (bodies.bulk())
      left.block(2) = bodies.bulk()->residual(u);
    if (system.is_saddle_point())
      {
        // The second unknown is p over the stiffness of the points, see ContactSystem.
        rhs.block(1) = of_pressure;
        rhs.block(1).scale(contact.coefficients.stiffness);
        rhs.block(1).scale(active);
        left.block(1) = law.defect({gap, s, p}, active);
      }
    else if (!contact.empty())
      {
        contact.B_free.Tvmult_add(rhs.block(0), by_gap(law, active, of_pressure));
        if (contact.has_stress())
          contact.S_free.Tvmult_add(rhs.block(0), by_stress(law, active, of_pressure));
      }
    bodies.constraints().set_zero(rhs.block(0));

    system.transpose(true);
    LA::BlockVector dual = system.zero();
    DualSolution    result;
    result.iterations = linear_solver.solve(dual, rhs, reduction, 0.);
    system.transpose(false);
    bodies.constraints().set_zero(dual.block(0));
    result.remainder = dual * left;

    // As a displacement: what is constrained follows, with nothing prescribed.
    LA::Vector prescribed = u;
    prescribed            = 0;
    bodies.constraints().distribute(prescribed);
    result.z = dual.block(0);
    bodies.constraints().distribute(result.z);
    result.z -= prescribed;

    result.zeta = contact.zero();
    if (system.is_saddle_point())
      {
        result.zeta = dual.block(1);
        result.zeta.scale(contact.coefficients.stiffness);
        result.zeta.scale(active);
      }
    else if (!contact.empty())
      {
        // By gaps that are not closed the pressure changes, and the forces with it.
        contact.B_free.vmult(result.zeta, result.z);
        result.zeta.scale(contact.weight);
        result.zeta += of_pressure;
        result.zeta = by_gap(law, active, result.zeta);
        for (const auto i : result.zeta.locally_owned_elements())
          if (contact.weight(i) > 0)
            result.zeta(i) /= contact.weight(i);
        result.zeta.compress(VectorOperation::insert);
      }
    return result;
  }
} // namespace Signorini
