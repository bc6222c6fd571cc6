#pragma once

#include <signorini/elasticity/deformation_kernel.h>
#include <signorini/elasticity/elasticity.h>
#include <signorini/solve/bodies.h>

#include <deal.II/base/timer.h>

#include <functional>

namespace Signorini
{
  /// Bodies that deform by any amount: F(u) = int P(u) : Grad v dV, with an assembled tangent.
  template <int dim>
  class FiniteBodies : public Bodies
  {
  public:
    /// Refers to elasticity, whose stiffness is assembled and whose bodies all have an energy, and
    /// to the timer.
    FiniteBodies(const Elasticity<dim>    &elasticity,
                 std::vector<unsigned int> body_of_dof,
                 dealii::TimerOutput      &timer);

    /// @param f Elasticity::load(), of bodies that deform by any amount
    void
    set_load(LA::Vector f) override;

    void
    start_from(const LA::Vector &u) override;

    /// Throws SolverFailure where cells are folded. Collective.
    LA::Vector
    residual(const LA::Vector &u) const override;

    /// Of loads, and of reactions at the last residual.
    double
    load_size() const override;

    void
    linearise(const LA::Vector &u) override;

    /// Halves the step until no cell folds, nor loses nine tenths of its volume.
    double
    longest_step(const LA::Vector &u, const LA::Vector &du) const override;

    const Stiffness &
    stiffness() const override
    {
      return my_stiffness;
    }

    const dealii::AffineConstraints<double> &
    constraints() const override
    {
      return elasticity.constraints();
    }

    const std::vector<unsigned int> &
    body_of_dof() const override
    {
      return bodies;
    }

  private:
    using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;

    /// Calls visit(cell, indices) for the locally owned cells.
    void
    for_cells(const std::function<void(const Cell                                         &cell,
                                       const std::vector<dealii::types::global_dof_index> &indices)>
                &visit) const;
    /// Does any rank say so? Throws SolverFailure then. Collective.
    void
    check_folds(const std::string &body_here) const;
    /// With the values of constrained degrees of freedom, which Newton's method leaves alone, and
    /// ghosts.
    LA::Vector
    obeying(LA::Vector u) const;
    LA::Vector
    forces(const LA::Vector &u) const;

    const Elasticity<dim>          &elasticity;
    const std::vector<unsigned int> bodies;
    dealii::TimerOutput            &timer;
    LA::SparseMatrix                K;
    AssembledStiffness              my_stiffness;
    LA::Vector                      f;
    LA::Vector                      origin;     ///< see start_from(); empty: none
    LA::Vector                      linearised; ///< where K is; empty: nowhere
    mutable DeformationKernel<dim>  kernel;
    mutable double                  reaction = 0; ///< size
  };
} // namespace Signorini
