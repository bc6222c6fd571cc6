// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "accuracy/quantity.h"
#include "driver/fixed_configuration_solver.h"
#include "fields/snapshot.h"

#include <functional>
#include <optional>

namespace Signorini
{
  /// The bodies in balance at a time: in place, and from there on where the surfaces have got to,
  /// as far as that counts. Lives as long as a run; what depends on the mesh is made when it is
  /// needed, and forgotten when that changes.
  template <int dim>
  class Equilibrium
  {
  public:
    /// Refers to all of them.
    /// @param watch makes what is called in each step of Newton's method; what it throws ends the
    /// solution, with `state` as the last iterate left it
    Equilibrium(const Decisions<dim>        &decisions,
                Elasticity<dim>             &elasticity,
                ContactInterfaces<dim>      &contact,
                State                       &state,
                dealii::TimerOutput         &timer,
                dealii::ConditionalOStream  &out,
                std::function<StepVisitor()> watch);

    /// Solves with contact as it is found where the surfaces are placed now.
    FixedConfigurationSolver<dim> configuration_solver;

    /// Look for contact there.
    void
    find_contact()
    {
      configuration_solver.find_contact(my_uses_current_geometry);
    }

    /// Solve at time t, starting from `state`, which becomes the solution. If there is none, it
    /// stays as it was.
    bool
    solve(double t, double tolerance);

    /// The state is another one: nothing at all, or that of a checkpoint.
    /// @param uses_current_geometry contact is where the surfaces are, from now on
    void
    set_state(const State &other, bool uses_current_geometry);

    /// The mesh is another one, and the state carried over to it.
    void
    invalidate();

    // Of the last solution:

    const NewtonReport &
    report() const
    {
      return my_report;
    }

    Snapshot<dim>
    snapshot(unsigned int step) const;

    /// The last iterate of a time that was not solved, where contact points that change to and fro
    /// have 2 in `active`; none if there is nothing to be drawn.
    std::optional<Snapshot<dim>>
    failure(unsigned int step) const;

    /// Contact is where the surfaces are, not where they were at rest.
    bool
    uses_current_geometry() const
    {
      return my_uses_current_geometry;
    }

    /// What following them would change: the share of the pressure, if it was estimated.
    std::optional<double>
    neglected() const
    {
      return my_neglected;
    }

  private:
    /// See solve(). @param start where the bodies are linearised first, predicted(); else the
    /// displacement of the state. Contact begins with surfaces as they are in the state in any
    /// case: where they are predicted to be, they may have gone through each other.
    bool
    solve_from(const std::optional<LA::Vector> &start, double t, double tolerance);
    /// Large deformation: where the last load step leads to, if there was one on this mesh and
    /// what drives the bodies goes on as it did.
    std::optional<LA::Vector>
    predicted(double t);
    bool
    solve_from_start(const std::optional<LA::Vector> &start, double t, double tolerance);
    void
    store_failure(double t);
    /// See NewtonReport::jump.
    double
    speed_ratio_since(const State &before);
    /// Does the tangent curve down on the straight way from there?
    bool
    is_indefinite_on_path_from(const State &before);
    /// That of the state.
    void
    restore_volumetric_stress();
    /// With the steps before in the report.
    bool
    solve_fixed_configuration(double t, const StoppingCriteria &stopping, bool is_near = false);
    /// Of the first solution of a load step, before surfaces are placed.
    StoppingCriteria
    first_stopping_criteria(double tolerance, bool is_predicted) const;
    /// Of those after surfaces are placed: with large deformation, one step of Newton's method.
    /// @param before what was out of balance at the last placement; 0: there was none
    StoppingCriteria
    next_stopping_criteria(double tolerance, double before) const;
    /// Do the surfaces move so far that contact has to be looked for where they are now?
    /// @param is_solution else displacements are near one, which is silent unless they do
    bool
    needs_geometry_update(bool is_solution);
    /// Place the surfaces where they are, and solve, until they stay: Newton's method for the
    /// dependence of gaps and normals on the displacement, of second order near the end.
    /// @param is_placed they are where they are
    bool
    update_geometry_until_converged(double t, double tolerance, bool is_placed);
    Snapshot<dim>
    snapshot(const State        &state,
             const LA::Vector   &gap,
             const ContactState &contact_state,
             const LA::Vector   &active,
             unsigned int        step) const;

    const Decisions<dim>       &decisions;
    const Scene<dim>           &scene;
    Elasticity<dim>            &elasticity;
    ContactInterfaces<dim>     &contact;
    State                      &state;
    dealii::TimerOutput        &timer;
    dealii::ConditionalOStream &out;

    LA::Vector              gap, active; ///< at the contact points; 1 or 0: closed or open
    bool                    my_uses_current_geometry = false;
    std::optional<double>   my_neglected;
    NewtonReport            my_report;
    std::vector<NewtonStep> previous_steps; ///< of this load step, with surfaces placed before

    double last_speed            = 0; ///< displacement per time of the last load step
    double last_prescribed_speed = 0; ///< that of supports and obstacles alone

    /// Before the last load step, on this mesh.
    struct PreviousSolution
    {
      LA::Vector displacement;
      double     time;
    };
    std::optional<PreviousSolution> previous_solution;

    struct Failure
    {
      State        state;
      LA::Vector   gap;
      ContactState contact;
      LA::Vector   active;
    };
    std::optional<Failure> my_failure;
  };
} // namespace Signorini
