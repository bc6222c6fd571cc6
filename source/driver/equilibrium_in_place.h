#pragma once

#include "driver/contact_setup.h"
#include "driver/state.h"
#include "solver/contact_solver.h"

#include <functional>
#include <memory>
#include <optional>

namespace Signorini
{
  /// The bodies in balance with contact as it is found at one place of the surfaces: at rest, or
  /// displaced. Makes bodies, hierarchies and the solver when they are needed, keeps them as long
  /// as they hold, and searches farther where surfaces may have come closer than contact was
  /// looked for.
  template <int dim>
  class EquilibriumInPlace
  {
  public:
    /// Refers to all of them.
    /// @param state where solutions start, and what they become
    /// @param watch makes what is called in each step of Newton's method
    EquilibriumInPlace(const Scene<dim>            &scene,
                       Elasticity<dim>             &elasticity,
                       ContactSetup<dim>           &contact,
                       State                       &state,
                       dealii::TimerOutput         &timer,
                       std::function<StepVisitor()> watch);

    /// Where surfaces will be when contact is found next. @param u empty: at rest
    void
    place(LA::Vector u)
    {
      placed = std::move(u);
    }

    /// See ContactSetup::build(). Pressures are those of the state, of active sets nothing is kept.
    void
    find_contact(bool is_near, bool keeps_points = false);

    /// Throws SceneError for motions that nothing can stop, SolverFailure if that is only so where
    /// surfaces are now.
    void
    check_motions()
    {
      make_free_motions();
    }

    /// Pressure and active set of the state.
    void
    recall_active_set();

    /// A load step starts: slip and internal variables of contact count from the start that the
    /// state has.
    void
    start_step();

    /// Bodies go on from there, where the next solution begins. @param u satisfies the supports of
    /// that solution
    void
    go_on_from(LA::Vector u)
    {
      left            = std::move(u);
      had_curved_down = false;
    }

    /// Solve for the loads at time t. Throws SolverFailure.
    /// @param is_near where contact has to be found again
    /// @return what it came to: whether converged() in report()
    bool
    solve(double t, const NewtonGoal &goal, bool is_near);

    /// The mesh is another one.
    void
    forget_mesh();

    /// Newton's method, multigrid and all that they hold; the results stay.
    void
    release();

    // Of the last solution:

    const NewtonReport &
    report() const
    {
      return my_report;
    }

    const ContactState &
    contact_state() const
    {
      return my_contact;
    }

    /// See Newton::curves_down(); false if there is no contact yet. Collective.
    bool
    curves_down(const LA::Vector &u)
    {
      return solver && solver->newton.curves_down(u, my_contact);
    }

    /// So was one on the way, since go_on_from().
    bool
    has_curved_down() const
    {
      return had_curved_down || (solver && solver->linear_solver.has_curved_down());
    }

    /// Its reaction to changes, seen by a quantity. Collective.
    DualSolution
    dual(const Functional &functional);

    // On this mesh so far:

    unsigned int
    multigrid_cycles() const
    {
      return former_cycles + (solver ? solver->linear_solver.multigrid_cycles() : 0);
    }

    /// Of this rank.
    double
    seconds() const
    {
      return clock.wall_time();
    }

  private:
    void
    solve_with_candidates(double t, const NewtonGoal &goal);
    void
    make_solver();
    void
    assemble();
    FreeMotions
    make_free_motions();
    void
    forget_solver();

    const Scene<dim>                  &scene;
    Elasticity<dim>                   &elasticity;
    ContactSetup<dim>                 &contact;
    State                             &state;
    dealii::TimerOutput               &timer;
    const std::function<StepVisitor()> watch;

    LA::Vector   placed; ///< displacement of surfaces; empty: at rest
    LA::Vector   left;   ///< the last solution, until the next has begun
    ContactState my_contact;

    // On this mesh:
    std::unique_ptr<Bodies>        bodies; ///< once they are assembled
    std::optional<BodiesHierarchy> hierarchies;
    std::unique_ptr<ContactSolver> solver; ///< for contact as it was found last

    NewtonReport  my_report;
    unsigned int  former_cycles   = 0;     ///< of multigrid, before `solver`
    bool          had_curved_down = false; ///< likewise
    dealii::Timer clock;                   ///< of the solves on this mesh
  };
} // namespace Signorini
