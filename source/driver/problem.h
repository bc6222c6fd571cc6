// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "driver/equilibrium.h"
#include "scene/decisions.h"

#include <memory>
#include <optional>
#include <vector>

namespace Signorini
{
  /// What a scene becomes on the present mesh: mesh, elasticity, contact interfaces, state, and
  /// what solves for equilibrium. Whatever changes them is here: other supports, finite strain,
  /// higher degrees, a refined mesh. All functions are collective.
  template <int dim>
  class Problem
  {
  public:
    /// Keeps references to all arguments but the communicator.
    /// @param watch makes the function that is called in each Newton step
    Problem(const Scene<dim>            &scene,
            MPI_Comm                     comm,
            dealii::ConditionalOStream  &out,
            dealii::TimerOutput         &timer,
            std::function<StepVisitor()> watch);

    /// The mesh as the scene describes it, and with it the contact pairs, if the scene leaves them
    /// open. Throws SceneError.
    void
    make_mesh();

    /// Elasticity and contact on that mesh, at zero displacement.
    void
    set_up();

    /// Solve at time t, starting from the last state; with `Deformation = automatic` at finite
    /// strain once that is needed. Returns false, and leaves the state as it was, if there is no
    /// solution.
    /// @param tolerance of the residual, relative to the acting forces
    bool
    solve(double t, double tolerance);

    /// Refine the cells that are marked, and transfer the state.
    void
    refine_mesh();

    /// Raise the degree of these bodies to 2 on the same mesh.
    void
    p_refine(const std::vector<unsigned int> &bodies);

    const NewtonReport &
    report() const
    {
      return equilibrium->report();
    }

    /// Multigrid cycles of the solves on this mesh, those before a restart included.
    unsigned int
    multigrid_cycles() const;

    /// Wall time of the solves on this mesh [s], the largest of all ranks.
    double
    mesh_seconds() const;

    Decisions<dim>                          decisions;
    std::unique_ptr<Mesh<dim>>              mesh;
    std::unique_ptr<Elasticity<dim>>        elasticity;
    std::unique_ptr<ContactInterfaces<dim>> contact;
    State                                   state;
    std::unique_ptr<Equilibrium<dim>>       equilibrium;
    /// The largest relative work error of small strain so far, with Deformation = automatic.
    std::optional<double> neglected_work;
    /// Multigrid cycles and solution time on this mesh before a restart or a change of supports.
    unsigned int former_cycles  = 0;
    double       former_seconds = 0;

  private:
    /// Start the counters of the next mesh, and free what belongs to the present one.
    void
    leave_mesh();
    /// Set up the contact interfaces for the present bodies.
    void
    set_up_contact();
    /// Change to the supports that act at time t, on the same mesh and from the same state;
    /// whatever depends on the constraints is rebuilt.
    void
    change_supports(double t);
    /// True if the error of small strain in the last solution is acceptable.
    bool
    is_small_enough();
    /// Switch to finite strain. Throws SceneError where the model uses features of small strain
    /// only.
    void
    switch_to_finite_strain(const State &before);
    /// Replace the elasticity on the same mesh. @param known ContactInterfaces::save()
    void
    replace_elasticity(std::unique_ptr<Elasticity<dim>> other,
                       const State                     &carried,
                       bool                             uses_current_geometry,
                       const nlohmann::ordered_json    &known);

    const Scene<dim>                  &scene;
    const MPI_Comm                     comm;
    dealii::ConditionalOStream        &out;
    dealii::TimerOutput               &timer;
    const std::function<StepVisitor()> watch;
  };
} // namespace Signorini
