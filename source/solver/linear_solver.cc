// SPDX-License-Identifier: Apache-2.0
#include "solver/linear_solver.h"

#include "linear_algebra/direct_solver.h"
#include "solver/preconditioners/schur_complement.h"
#include "solver/preconditioners/volumetric_schur.h"
#include <signorini/base/scene_error.h>
#include <signorini/base/text.h>

#include <deal.II/lac/solver_minres.h>

#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Choose the library for factorisations. On one rank SparseLU is the fastest for matrices of a
    /// contact interface and small ones; for the whole system in space MUMPS is, and for interfaces
    /// that include the geometric stiffness.
    LA::DirectLibrary
    choose_direct(const LinearSolverSettings &settings,
                  const Stiffness            &stiffness,
                  const bool                  interface_includes_geometric)
    {
      const bool has_mumps = LA::DirectSolver::is_available(LA::DirectLibrary::MUMPS);
      if (settings.direct_solver == LA::DirectLibrary::MUMPS && !has_mumps)
        throw SceneError(
          "Solver/Direct solver = MUMPS: this Trilinos was built without MUMPS; set auto or KLU");
      constexpr unsigned int small = 2000;
      const bool is_serial         = Utilities::MPI::n_mpi_processes(stiffness.communicator()) == 1;
      if (settings.direct_solver == LA::DirectLibrary::SparseLU && !is_serial)
        throw SceneError("Solver/Direct solver = SparseLU works on one rank only; set auto");
      if (settings.direct_solver)
        return *settings.direct_solver;
      const bool is_large =
        interface_includes_geometric || (settings.traits().factorises && stiffness.size() > small);
      return has_mumps && (!is_serial || is_large) ? LA::DirectLibrary::MUMPS :
             is_serial                             ? LA::DirectLibrary::SparseLU :
                                                     LA::DirectLibrary::KLU;
    }

    /// Choose the Krylov method (doc/theory, 7.8), or check that the one of the settings is valid
    /// for system and preconditioner. Throws SceneError.
    Krylov
    choose_krylov(const LinearSolverSettings &settings,
                  const ContactSystem        &system,
                  const Preconditioner       &preconditioner)
    {
      if (system.volumetric())
        {
          if (settings.krylov && *settings.krylov != Krylov::FGMRES)
            throw SceneError(
              "Solver/Krylov method = " + word_of(krylov_methods(), *settings.krylov) +
              ": bodies with Formulation = mixed require FGMRES; set Krylov method = FGMRES or auto");
          return Krylov::FGMRES;
        }
      // The factors of a direct preconditioner do not contain the geometric stiffness, which may
      // make the system indefinite.
      const bool lacks_motion = settings.traits().factorises && !system.gap_operator().at_rest();
      if (lacks_motion && !settings.krylov)
        return Krylov::FGMRES;
      if (!system.is_symmetric())
        {
          if (settings.krylov == Krylov::CG || settings.krylov == Krylov::MINRES)
            throw SceneError(
              "Solver/Krylov method = " + word_of(krylov_methods(), *settings.krylov) +
              " requires a symmetric system, but Nitsche's method with Theta = 0 or -1 and follower "
              "pressures are not symmetric; set Krylov method = auto (FGMRES)");
          return Krylov::FGMRES;
        }
      if (!system.is_saddle_point())
        {
          if (settings.krylov == Krylov::MINRES)
            throw SceneError(
              "Solver/Krylov method = MINRES is for saddle-point systems; set CG or auto");
          return settings.krylov.value_or(Krylov::CG);
        }
      if (!settings.krylov)
        return preconditioner.preserves_constraints() ? Krylov::CG :
               preconditioner.is_positive_definite()  ? Krylov::MINRES :
                                                        Krylov::FGMRES;
      if (settings.krylov == Krylov::CG && !preconditioner.preserves_constraints())
        throw SceneError(
          "Solver/Krylov method = CG with multipliers requires a constraint preconditioner, but "
          "Solver/Preconditioner = " +
          settings.preconditioner +
          " is none; set Preconditioner = interface multigrid, or Krylov method = FGMRES");
      if (settings.krylov == Krylov::MINRES && !preconditioner.is_positive_definite())
        throw SceneError(
          "Solver/Krylov method = MINRES requires a positive definite preconditioner, but Solver/Preconditioner = " +
          settings.preconditioner + " with Schur complement = " + settings.schur_complement +
          " is indefinite; set Preconditioner = block diagonal with a Schur complement other than "
          "multigrid, or Krylov method = FGMRES");
      return *settings.krylov;
    }
  } // namespace



  LinearSolver::LinearSolver(const LinearSolverSettings &settings,
                             const ContactSystem        &system,
                             SolidHierarchy             &hierarchies,
                             TimerOutput                &timer)
    : settings(settings)
    , system(system)
    , hierarchies(hierarchies)
    , timer(timer)
  {
    if (!settings.traits().admits_augmentation && settings.augmentation > 0)
      throw SceneError(
        "Solver/Augmentation = " + short_text(settings.augmentation) +
        " cannot be combined with Preconditioner = " + settings.preconditioner +
        ", which uses the stiffness without augmentation; set Preconditioner = block triangular");
  }



  // Make hierarchy and preconditioner for the present stiffness; the former ones are released
  // before, so that memory is not needed twice.
  void
  LinearSolver::make_preconditioner()
  {
    if (preconditioner)
      cycles_before += preconditioner->multigrid_cycles();
    preconditioner.reset();
    hierarchy.reset();
    if (settings.traits().uses_hierarchy)
      hierarchy = hierarchies.get();
    LinearSolverSettings chosen = settings;
    chosen.direct_solver        = choose_direct(settings,
                                         system.stiffness(),
                                         hierarchies.interface_includes_geometric_stiffness());
    preconditioner              = Preconditioner::create(chosen,
                                            system,
                                            hierarchy.get(),
                                            hierarchies.interface_includes_geometric_stiffness());
    if (system.volumetric())
      preconditioner =
        std::make_unique<VolumetricSchur>(system, *system.volumetric(), std::move(preconditioner));
    version = system.stiffness().version();
  }



  // Falling back to a factorisation is an option for interface multigrid and moderate sizes only.
  bool
  LinearSolver::can_factorise() const
  {
    // Sizes whose factorisation takes about a minute.
    const unsigned int most = hierarchies.dim() == 2 ? 400000 : 60000;
    return settings.traits().solves_interface && system.stiffness().size() <= most;
  }



  void
  LinearSolver::update()
  {
    TimerOutput::Scope scope(timer, "preconditioner");
    if (version != system.stiffness().version())
      make_preconditioner();
    preconditioner->update();
  }



  bool
  LinearSolver::interface_lacks_geometric() const
  {
    return settings.traits().solves_interface && system.uses_geometric_stiffness() &&
           !system.gap_operator().at_rest() &&
           !hierarchies.interface_includes_geometric_stiffness();
  }



  // Include the geometric stiffness in interface solves, or not; the preconditioner is made again
  // only if it has to contain more than before.
  bool
  LinearSolver::include_geometric_in_interface(const bool wanted)
  {
    const bool did     = hierarchies.interface_includes_geometric_stiffness();
    const bool is_news = wanted && interface_lacks_geometric();
    hierarchies.include_geometric_in_interface(wanted);
    if (is_news)
      {
        make_preconditioner();
        preconditioner->update();
      }
    return did;
  }



  // Make a better preconditioner, in two stages: rebuild a hierarchy of a former stiffness; if it
  // is up to date, include the geometric stiffness in the interface solve. Returns false if nothing
  // is left to improve.
  bool
  LinearSolver::request_rebuild()
  {
    if (!settings.traits().uses_hierarchy)
      return false;
    if (!hierarchies.request_rebuild())
      return interface_lacks_geometric() && !include_geometric_in_interface(true);
    hierarchies.include_geometric_in_interface(
      hierarchies.interface_includes_geometric_stiffness() || interface_lacks_geometric());
    make_preconditioner();
    preconditioner->update();
    return true;
  }



  // A test of definiteness must not fall back to a factorisation, which does not detect negative
  // curvature.
  bool
  LinearSolver::factorise(const NegativeCurvature curvature)
  {
    if (curvature == NegativeCurvature::report || !can_factorise())
      return false;
    has_failed_iterating    = true;
    settings.preconditioner = "direct";
    make_preconditioner();
    preconditioner->update();
    return true;
  }



  unsigned int
  LinearSolver::solve(LA::BlockVector        &x,
                      const LA::BlockVector  &rhs,
                      const double            reduction,
                      const double            absolute_tolerance,
                      const NegativeCurvature curvature)
  {
    // Each failure escalates: rebuild the hierarchy for this stiffness, include the geometric
    // stiffness in the interface solve, factorise. Each of these happens at most once for a
    // stiffness, so the loop ends.
    for (;;)
      try
        {
          return solve_once(x, rhs, reduction, absolute_tolerance, curvature);
        }
      catch (const IndefiniteSystem &)
        {
          throw;
        }
      catch (const SolverFailure &)
        {
          if (!request_rebuild() && !factorise(curvature))
            throw;
        }
  }



  // One solution with the present preconditioner: start vector, tolerance relative to the residual
  // after it (doc/theory, 4.8), Krylov iteration.
  unsigned int
  LinearSolver::solve_once(LA::BlockVector        &x,
                           const LA::BlockVector  &rhs,
                           const double            reduction,
                           const double            absolute_tolerance,
                           const NegativeCurvature curvature)
  {
    TimerOutput::Scope scope(timer, "krylov");
    const Krylov       krylov = choose_krylov(settings, system, *preconditioner);

    x = 0;
    // If CG has met negative curvature before the system was factorised, that is still true; the
    // factorisation does not detect it.
    is_indefinite = is_indefinite && has_failed_iterating;
    if (preconditioner->is_exact() && !system.is_transposed())
      {
        preconditioner->vmult(x, rhs);
        return 1;
      }
    const double norm = rhs.l2_norm();
    if (norm == 0)
      return 0;
    preconditioner->start(x, rhs);
    double tolerance = absolute_tolerance;
    if (reduction > 0)
      {
        LA::BlockVector rest = system.zero();
        system.vmult(rest, x);
        rest.sadd(-1, 1, rhs);
        tolerance = std::max(tolerance, reduction * std::min(norm, rest.l2_norm()));
      }
    if (krylov == Krylov::MINRES)
      {
        // MINRES measures residuals in the norm of the preconditioner.
        LA::BlockVector preconditioned = rhs;
        preconditioner->vmult(preconditioned, rhs);
        tolerance *= std::sqrt(rhs * preconditioned) / norm;
        // A start at zero with forces or gaps alone on the right-hand side would make the first
        // rotation one by ninety degrees, and SolverMinRes divides by its cosine.
        x = preconditioned;
      }
    return iterate(krylov, tolerance, x, rhs, curvature);
  }
} // namespace Signorini
