// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "multigrid/prolongation.h"
#include "solid/elasticity.h"

#include <memory>

namespace Signorini
{
  /// Displacements of degree one on the mesh of the bodies, numbered as Displacements are: those of
  /// rigid bodies last. At its nodes, supports do as they do at those of the bodies.
  template <int dim>
  class LinearSpace
  {
  public:
    explicit LinearSpace(const Elasticity<dim> &fine);

    const dealii::hp::FECollection<dim> elements;
    dealii::DoFHandler<dim>             dofs;
    dealii::IndexSet                    owned, relevant;
    dealii::AffineConstraints<double>   hanging, constraints; ///< hanging nodes; and supports

  private:
    void
    number(const Elasticity<dim> &fine);
    void
    constrain_vertices(const Elasticity<dim> &fine);
    void
    constrain_rigid_bodies(const Elasticity<dim> &fine);
  };

  /// From the space of degree one to that of the bodies. Collective.
  template <int dim>
  std::unique_ptr<const Prolongation>
  make_prolongation(const Elasticity<dim> &fine, const LinearSpace<dim> &space);

  /// What K has on its diagonal beyond the stiffness of cells on a level below another one: the
  /// springs against unconstrained rigid-body modes, each at the nodes that it moves, and what is
  /// prescribed to rigid bodies. Collective.
  /// @param terms of the level above
  /// @param n_rigid degrees of freedom of rigid bodies, the last ones of both levels
  LA::Vector
  restrict_terms(const LA::Vector       &terms,
                 const Prolongation     &P,
                 const dealii::IndexSet &owned,
                 unsigned int            n_rigid);

  /// Supports at nodes of the bodies that the space of degree one has not: how far its
  /// displacements are from what they ask for, as springs of those nodes' stiffness.
  class CoarseConstraintPenalty
  {
  public:
    /// @param diagonal of the bodies' stiffness
    template <int dim>
    CoarseConstraintPenalty(const Elasticity<dim>  &fine,
                            const LinearSpace<dim> &space,
                            const LA::Vector       &diagonal);

    /// On any rank? Collective.
    bool
    any() const;

    /// To a matrix that has the places of all cells. It is not compressed.
    void
    add_to(LA::SparseMatrix &K) const;

  private:
    struct Penalty
    {
      double                                                          stiffness;
      std::vector<std::pair<dealii::types::global_dof_index, double>> row;
    };

    std::vector<Penalty> penalties;
    MPI_Comm             comm;
  };
} // namespace Signorini
