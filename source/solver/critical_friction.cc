// SPDX-License-Identifier: Apache-2.0
// Whether friction at slipping points is so large that the solution is one of several.
#include "solver/newton.h"

#include <deal.II/lac/precondition.h>
#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/solver_gmres.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Accuracy of the linear solver and of the eigenvalues.
    constexpr double reduction = 1e-2;

    /// The product with A^-1 A_0 = I + A^-1 (A_0 - A), where A_0 is the tangent A for a given bound
    /// of friction. The difference is that of the contact terms.
    struct GivenBound
    {
      const ContactSystem &coulomb, &tresca; ///< A and A_0
      LinearSolver        &linear_solver;    ///< of A

      void
      vmult(LA::BlockVector &dst, const LA::BlockVector &src) const
      {
        LA::BlockVector difference = src;
        tresca.contact_terms(difference, src);
        coulomb.contact_terms(dst, src);
        difference -= dst;
        linear_solver.solve(dst, difference, reduction, 0.);
        dst += src;
      }
    };
  } // namespace



  // The eigenvalues 1/(1 - lambda) of A^-1 A_0 (doc/theory, (4.25)), as GMRES finds them on its way
  // to a solution. It starts from forces along the slip that have no symmetry, so that they excite
  // all modes.
  double
  Newton::friction_over_critical(const LA::Vector &u, const ContactState &state)
  {
    const PointVectors gaps = contact.gaps(u), s = contact.stress(u, bodies.volumetric_stress());
    const LawInputs    in{gaps, s, state.traction, state.internal};
    LA::Vector         pushes = contact.zero();
    for (const auto i : pushes.locally_owned_elements())
      if (status_of(strategy.status()(i)) == ContactStatus::slip &&
          contact.coefficients.friction(i) > 0)
        pushes(i) = (1 + 0.5 * std::sin(37. * i * i + 11. * i)) * contact.weight(i) *
                    contact.coefficients.stiffness(i);
    pushes.compress(VectorOperation::insert);
    if (pushes.linfty_norm() == 0 || !law.give_friction_bound(true))
      return 0;

    ContactSystem tresca(bodies.stiffness(),
                         law,
                         system.unconstrained_modes(),
                         system.volumetric(),
                         bodies.is_symmetric());
    tresca.linearise(in, strategy.status());
    law.give_friction_bound(false);
    linearise(u, in);

    LA::BlockVector forces = system.zero(), start = system.zero(), x_end = system.zero();
    for (unsigned int a = 1; a < law.n_components(); ++a)
      contact.free_rows(a).Tvmult_add(forces.block(0), pushes);
    bodies.constraints().set_zero(forces.block(0));

    constexpr unsigned int       most   = 20;
    double                       result = 0;
    ReductionControl             control(most, 0., reduction, false, false);
    SolverGMRES<LA::BlockVector> gmres(control);
    gmres.connect_eigenvalues_slot(
      [&](const std::vector<std::complex<double>> &eigenvalues) {
        constexpr double rounding = 1e-6;
        result                    = 0;
        for (const auto &value : eigenvalues)
          if (std::abs(value.imag()) <= rounding * std::abs(value))
            result = std::max(result, 1 - 1 / value.real());
      },
      true);
    try
      {
        linear_solver.solve(start, forces, reduction, 0.);
        gmres.solve(GivenBound{system, tresca, linear_solver},
                    x_end,
                    start,
                    PreconditionIdentity());
      }
    catch (const SolverControl::NoConvergence &)
      {}
    catch (const SolverFailure &)
      // What was found until then counts.
      {}
    return result;
  }
} // namespace Signorini
