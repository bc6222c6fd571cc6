#pragma once

#include <signorini/contact/law/contact_law.h>
#include <signorini/solve/active_set.h>
#include <signorini/solve/linear_solver.h>

#include <deal.II/base/conditional_ostream.h>
#include <deal.II/base/timer.h>
#include <deal.II/lac/affine_constraints.h>

#include <string>
#include <vector>

namespace Signorini
{
  struct NewtonSettings
  {
    unsigned int maximum_steps = 40;
    double       tolerance     = 1e-10;
    double       reduction     = 1e-2;
    double       stabilisation = 0.25;
    std::string  undetermined  = "refuse";

    /// What to do about motions that nothing determines, for messages.
    static std::string
    how_to_hold();

    void
    declare(Section &section);
  };

  struct NewtonStep
  {
    unsigned int active = 0, changes = 0, krylov_iterations = 0;
    double       residual = 0, gap_residual = 0, damping = 1;
    double residual_of_bodies = 0;     ///< the largest one of a body, see Newton::forces_at_work()
    bool   follows            = false; ///< takes over the active set of the last load step
    bool   withholds = false; ///< overlapping points are not active yet, see keep_deepest()
    bool   augments  = false; ///< a solution, from which the next augmentation starts
  };

  struct NewtonReport
  {
    bool                    converged = false;
    std::string             reason; ///< why not
    std::vector<NewtonStep> steps;
    /// Motions that neither supports nor contact determine: they are held, by at most that force.
    std::vector<std::string> undetermined;
    double                   holding_force = 0;
    bool                     is_loose      = false; ///< that is why it did not converge
  };

  /// Semismooth Newton method for K u = f + B^T W p with the contact law between p and the gap:
  /// since all else is linear, it is the primal-dual active set strategy (Hintermueller, Ito,
  /// Kunisch, SIAM J. Optim. 13 (2003) 865). Lives as long as the mesh does.
  ///
  /// Full steps, which find the active set in a few, until one comes up again. If it still does
  /// with finer linear solves, then from there on
  /// methods with multipliers change one point at a time, the worst; the others minimise a convex
  /// energy (but for Nitsche's method with theta = 0 or -1), along which each step is searched
  /// exactly: it costs vectors of the surface only. If the method augments, one solution follows
  /// the other.
  class Newton
  {
  public:
    Newton(const NewtonSettings                    &settings,
           const LinearSolverSettings              &linear_settings,
           const ContactMethod                     &method,
           const LA::SparseMatrix                  &stiffness,
           const dealii::AffineConstraints<double> &constraints,
           const GapOperator                       &contact,
           const std::vector<std::vector<double>>  &modes,
           const std::vector<unsigned int>         &bodies,
           unsigned int                             dim,
           dealii::TimerOutput                     &timer,
           FreeMotions                              free_motions = FreeMotions());

    // bodies: Elasticity::bodies_of_dofs().

    /// @param f load vector with prescribed displacements eliminated
    /// @param u in: start, with the prescribed displacements of this step; out: solution
    /// @param p pressure at the contact points, in: start, out: solution
    /// @param active the points that carry it, 1 or 0, likewise
    NewtonReport
    solve(const LA::Vector           &f,
          LA::Vector                 &u,
          LA::Vector                 &p,
          LA::Vector                 &active,
          dealii::ConditionalOStream &out);

    unsigned int
    multigrid_cycles() const
    {
      return linear_solver.multigrid_cycles();
    }

  private:
    /// True if solutions are minima of an energy in the displacement.
    bool
    has_energy() const;
    void
    augment(const LA::Vector &p);
    /// Forces and the active set are those of a solution; with augmentations, of the present one.
    /// @param before residual of the last step, to see that it does not fall any more
    bool
    is_balanced(const NewtonStep &step, double before, double scale) const;
    /// So are the gaps.
    bool
    is_closed(const NewtonStep &step, double scale) const;
    unsigned int
    solve_linear(LA::BlockVector            &x,
                 const LA::BlockVector      &rhs,
                 double                      reduction,
                 double                      tolerance,
                 dealii::ConditionalOStream &out);
    /// At points that may separate.
    bool
    has_no_pressure(const LA::Vector &p) const;

    /// @param was_idle the last step changed nothing
    void
    update_active_set(const LawInputs &in, unsigned int n, bool was_idle, NewtonStep &step);
    /// What touches at the start holds all that contact could hold: so does a stack of blocks, a
    /// ball on a plane does not.
    bool
    touches_where_it_can(const LA::Vector &gap);
    LA::Vector
    residual(const LA::Vector &f,
             const LA::Vector &u,
             const LA::Vector &p,
             const LA::Vector &stress);
    /// Body by body, what residuals have to be small beside. That of all, which a support that
    /// moves a stiff body makes large though the body is free of stress in the end, is not what
    /// acts on a soft one; so it counts up to a thousand times the contact force.
    std::vector<double>
    forces_at_work(const LA::Vector &contact_force, double scale) const;
    /// Of the parts of a vector.
    std::vector<double>
    norms_of_bodies(const LA::Vector &force) const;
    /// Relative to the forces at work, the largest one.
    double
    residual_of_bodies(const LA::Vector &r) const;
    /// Of the bodies' forces, and of penalties, which multiply that of the gap; in the norm of the
    /// residual.
    double
    rounding(const LA::Vector &u) const;
    double
    line_search(const LA::Vector &r, const LawInputs &in, const LA::Vector &du) const;

    const NewtonSettings                     settings;
    const LA::SparseMatrix                  &K;
    const dealii::AffineConstraints<double> &constraints;
    const GapOperator                       &contact;
    ContactLaw                               law;
    ContactSystem                            system;
    LinearSolver                             linear_solver;

    const std::vector<unsigned int> bodies;
    unsigned int                    n_bodies = 0;

    ActiveSet           active_set;
    LA::Vector          stiffness_diagonal;
    bool                is_cold     = true; ///< without a pressure to start from
    bool                cautious    = false;
    double              reduction   = 1e-2;  ///< by linear solves while the active set changes
    bool                factorised  = false; ///< the system is that of the active set
    double              force_scale = 0, largest_force = 0, force_rounding = 0;
    std::vector<double> at_work; ///< forces_at_work() now
  };
} // namespace Signorini
