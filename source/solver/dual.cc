// SPDX-License-Identifier: Apache-2.0
#include "solver/newton.h"

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The chain rule for tractions that follow from the law: at each point the vector
    /// `of_traction` times the derivative of the traction that `derivative` selects from the
    /// response.
    template <typename Derivative>
    PointVectors
    derivative_by_law(const ContactLaw   &law,
                      const LawInputs    &in,
                      const LA::Vector   &status,
                      const PointVectors &of_traction,
                      const Derivative   &derivative)
    {
      PointVectors result = law.gap_operator().zeros();
      for (const auto i : status.locally_owned_elements())
        {
          const LawMatrix by = derivative(law.response(i, in.at(i), status_of(status(i))));
          for (unsigned int b = 0; b < result.size(); ++b)
            {
              double sum = 0;
              for (unsigned int a = 0; a < result.size(); ++a)
                sum += of_traction[a](i) * by[a][b];
              result[b](i) = sum;
            }
        }
      for (LA::Vector &component : result)
        component.compress(VectorOperation::insert);
      return result;
    }

    /// The derivative of the traction with respect to the gap.
    LawMatrix
    by_gap(const LawResponse &response)
    {
      return response.by_gap;
    }

    /// The derivative of the traction with respect to the stress.
    LawMatrix
    by_stress(const LawResponse &response)
    {
      return response.by_stress;
    }
    /// The derivative of a quantity of the tractions with respect to the unknowns of the system: to
    /// the multipliers in a saddle point, otherwise through gaps and stresses to the displacement.
    LA::BlockVector
    gradient(const ContactSystem &system,
             const ContactLaw    &law,
             const LawInputs     &in,
             const LA::Vector    &status,
             const PointVectors  &of_traction)
    {
      const GapOperator &contact = law.gap_operator();
      LA::BlockVector    result  = system.zero();
      if (contact.empty())
        return result;
      if (system.is_saddle_point())
        {
          for (unsigned int a = 0; a < of_traction.size(); ++a)
            {
              result.block(1 + a) = of_traction[a];
              to_traction(contact, status, result.block(1 + a));
            }
          return result;
        }
      const PointVectors gap    = derivative_by_law(law, in, status, of_traction, by_gap),
                         stress = derivative_by_law(law, in, status, of_traction, by_stress);
      for (unsigned int a = 0; a < gap.size(); ++a)
        {
          contact.free_rows(a).Tvmult_add(result.block(0), gap[a]);
          if (contact.has_stress())
            contact.S_free[a].Tvmult_add(result.block(0), stress[a]);
          if (contact.has_volumetric_stress())
            contact.S_volumetric[a].Tvmult_add(result.block(system.volumetric_block()), stress[a]);
        }
      return result;
    }
  } // namespace



  // Dual problem (doc/theory, (8.2)): the transposed linearisation at the solution, with the
  // derivative of the quantity as right-hand side. The product of its solution with the residual of
  // the primal problem is the algebraic error. Collective.
  DualSolution
  Newton::dual(const LA::Vector   &u,
               const ContactState &state,
               const LA::Vector   &of_displacement,
               const LA::Vector   &of_volumetric_stress,
               const PointVectors &of_traction,
               const double        reduction)
  {
    const PointVectors gaps = contact.gaps(u), s = contact.stress(u, bodies.volumetric_stress());
    const LawInputs    in{gaps, s, state.traction, state.internal};
    const unsigned int n_q = system.is_saddle_point() ? law.n_components() : 0;
    linearise(u, in);
    LA::BlockVector left = system.zero();
    left.block(0)        = convergence.residual(u, in, state.status);
    if (bodies.volumetric())
      left.block(system.volumetric_block()) = bodies.volumetric()->residual(u);
    if (system.is_saddle_point())
      {
        const PointVectors residual = law.residual(in, state.status);
        for (unsigned int a = 0; a < n_q; ++a)
          left.block(1 + a) = residual[a];
      }
    LA::BlockVector rhs = gradient(system, law, in, state.status, of_traction);
    rhs.block(0) += of_displacement;
    bodies.constraints().set_zero(rhs.block(0));
    if (of_volumetric_stress.size() > 0)
      rhs.block(system.volumetric_block()) += of_volumetric_stress;

    system.transpose(true);
    LA::BlockVector dual = system.zero();
    DualSolution    result;
    result.iterations = linear_solver.solve(dual, rhs, reduction, 0.);
    system.transpose(false);
    bodies.constraints().set_zero(dual.block(0));
    result.remainder = dual * left;

    // As a displacement: constrained components follow from the others, with homogeneous values.
    LA::Vector prescribed = u;
    prescribed            = 0;
    bodies.constraints().distribute(prescribed);
    result.z = dual.block(0);
    bodies.constraints().distribute(result.z);
    result.z -= prescribed;

    if (bodies.volumetric())
      result.volumetric_stress = dual.block(system.volumetric_block());

    result.zeta = contact.zeros();
    for (unsigned int a = 0; a < n_q; ++a)
      {
        result.zeta[a] = dual.block(1 + a);
        to_traction(contact, state.status, result.zeta[a]);
      }
    if (system.is_saddle_point() || contact.empty())
      return result;
    // Condensed form: the dual tractions follow from the change of tractions and forces with the
    // gap (doc/theory, (8.3)).
    for (unsigned int a = 0; a < result.zeta.size(); ++a)
      {
        contact.free_rows(a).vmult(result.zeta[a], result.z);
        result.zeta[a].scale(contact.weight);
        result.zeta[a] += of_traction[a];
      }
    result.zeta = derivative_by_law(law, in, state.status, result.zeta, by_gap);
    for (LA::Vector &component : result.zeta)
      {
        for (const auto i : component.locally_owned_elements())
          if (contact.weight(i) > 0)
            component(i) /= contact.weight(i);
        component.compress(VectorOperation::insert);
      }
    return result;
  }
} // namespace Signorini
