// SPDX-License-Identifier: Apache-2.0
// The Krylov iterations of the linear solver.
#include "solver/linear_solver.h"
#include <signorini/base/text.h>

#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/solver_gmres.h>
#include <deal.II/lac/solver_minres.h>

#include <cmath>

namespace Signorini
{
  using namespace dealii;

  // Conjugate gradients with a monitor of their coefficients (doc/theory, 7.4). Depending on
  // `curvature`, negative curvature is ignored, reported by an exception, or truncates the
  // iteration at the last iterate before it (Steihaug). With a limit of 50 iterations, systems that
  // converge slowly count as nearly indefinite.
  unsigned int
  LinearSolver::conjugate_gradients(SolverControl          &control,
                                    LA::BlockVector        &x,
                                    const LA::BlockVector  &rhs,
                                    const NegativeCurvature curvature)
  {
    constexpr unsigned int patience = 50;
    const bool             is_limited =
      curvature == NegativeCurvature::reject || curvature == NegativeCurvature::truncate;
    const LA::BlockVector     start = x;
    unsigned int              n     = 0;
    IterationNumberControl    limited(patience, control.tolerance());
    SolverControl            &chosen = is_limited ? limited : control;
    SolverCG<LA::BlockVector> solver(chosen);
    // alpha = r.z/p.Ap is negative for a direction p of negative curvature of the system; beta =
    // r.z/(r.z before) is negative if the preconditioner is indefinite, as its coarsest level is
    // where the system is.
    solver.connect_coefficients_slot([&](const double alpha, const double beta) {
      ++n;
      is_indefinite = is_indefinite || alpha < 0 || beta < 0;
      if (is_indefinite && curvature != NegativeCurvature::ignore)
        throw IndefiniteSystem("the system is not positive definite");
      was_ever_indefinite = was_ever_indefinite || is_indefinite;
    });
    try
      {
        solver.solve(system, x, rhs, *preconditioner);
        if (curvature == NegativeCurvature::reject && chosen.last_value() > chosen.tolerance())
          throw IndefiniteSystem("the system is nearly indefinite");
        record_iterations(chosen.last_step(), chosen.initial_value(), chosen.last_value());
        return chosen.last_step();
      }
    catch (const IndefiniteSystem &)
      {
        if (curvature != NegativeCurvature::truncate)
          throw;
      }
    // Truncation: the iterate before the direction of negative curvature is the result. SolverCG
    // does not return it, therefore CG is repeated up to there.
    x = start;
    // The negative curvature may have been that of an old preconditioner.
    if (request_rebuild())
      {
        is_indefinite = false;
        return n + conjugate_gradients(control, x, rhs, curvature);
      }
    was_ever_indefinite = true;
    // Negative curvature in the first iteration: the preconditioned residual is a descent
    // direction.
    if (n == 1)
      {
        LA::BlockVector rest = rhs, down = rhs;
        system.vmult(rest, x);
        rest.sadd(-1, 1, rhs);
        preconditioner->vmult(down, rest);
        x += down;
        return n;
      }
    IterationNumberControl few(n - 1, control.tolerance());
    SolverCG<LA::BlockVector>(few).solve(system, x, rhs, *preconditioner);
    return 2 * n - 1;
  }



  // The number of iterations after which another method is faster.
  unsigned int
  LinearSolver::iteration_limit(const NegativeCurvature curvature) const
  {
    // Beyond these numbers a factorisation, or an interface solve with the geometric stiffness, is
    // faster; and if only negative curvature is looked for, it would have been found.
    constexpr unsigned int patience = 200, little_patience = 50;
    const bool             is_limited = curvature == NegativeCurvature::report || can_factorise();
    return std::min(settings.maximum_iterations,
                    interface_lacks_geometric() ? little_patience :
                    is_limited                  ? patience :
                                                  settings.maximum_iterations);
  }



  // Run the chosen Krylov method; no convergence becomes a SolverFailure with advice. FGMRES
  // restarts after 50 vectors.
  unsigned int
  LinearSolver::iterate(const Krylov            krylov,
                        const double            tolerance,
                        LA::BlockVector        &x,
                        const LA::BlockVector  &rhs,
                        const NegativeCurvature curvature)
  {
    SolverControl control(iteration_limit(curvature), tolerance);
    try
      {
        switch (krylov)
          {
            case Krylov::CG:
              return conjugate_gradients(control, x, rhs, curvature);
            case Krylov::MINRES:
              SolverMinRes<LA::BlockVector>(control).solve(system, x, rhs, *preconditioner);
              break;
            case Krylov::FGMRES:
              SolverFGMRES<LA::BlockVector>(control,
                                            SolverFGMRES<LA::BlockVector>::AdditionalData(50))
                .solve(system, x, rhs, *preconditioner);
              break;
          }
        record_iterations(control.last_step(), control.initial_value(), control.last_value());
        return control.last_step();
      }
    catch (const SolverControl::NoConvergence &stop)
      {
        throw SolverFailure(
          word_of(krylov_methods(), krylov) + " with the preconditioner '" +
          settings.preconditioner + "' stopped after " + std::to_string(stop.last_step) +
          " iterations with residual " + short_text(stop.last_residual / rhs.l2_norm()) +
          " of the start; " +
          (settings.traits().factorises ?
             "the system is nearly singular: check the supports, and nodes that belong to two pairs" :
             "choose another Solver/Preconditioner (interface multigrid, direct), or a smaller "
             "Factor of the contact method"));
      }
  }



  // Iterations per digit indicate whether the hierarchy still fits (SolidHierarchy); many
  // iterations indicate that the next interface solve should contain the geometric stiffness.
  void
  LinearSolver::record_iterations(const unsigned int iterations,
                                  const double       first,
                                  const double       last)
  {
    constexpr unsigned int many = 20;
    if (iterations > many && interface_lacks_geometric())
      hierarchies.include_geometric_in_interface(true); // of the next system
    const double digits = last > 0 ? std::log10(first / last) : 0;
    if (hierarchy && digits >= 1)
      hierarchies.record_iterations(iterations / digits);
  }
} // namespace Signorini
