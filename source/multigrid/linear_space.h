// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "multigrid/prolongation.h"
#include "solid/elasticity.h"

#include <map>
#include <memory>

namespace Signorini
{
  /// Displacements of degree one on the mesh of the bodies, with the degrees of freedom of rigid
  /// bodies last, as in Displacements. Vertices are constrained as the nodes of the bodies there.
  template <int dim>
  class LinearSpace
  {
  public:
    explicit LinearSpace(const Elasticity<dim> &fine);

    const dealii::hp::FECollection<dim> elements;
    dealii::DoFHandler<dim>             dofs;
    dealii::IndexSet                    owned, relevant;
    /// Constraints of hanging nodes; and those of supports in addition.
    dealii::AffineConstraints<double> hanging, constraints;

  private:
    /// Number the degrees of freedom, with those of rigid bodies.
    void
    number(const Elasticity<dim> &fine);
    /// Find the vertices of constraint equations on all ranks. Collective.
    void
    find_vertices_of_equations(const Elasticity<dim> &fine);
    /// Constrain vertices by supports and equations.
    void
    constrain_vertices(const Elasticity<dim> &fine);
    /// Constrain prescribed motions of rigid bodies.
    void
    constrain_rigid_bodies(const Elasticity<dim> &fine);

    /// Degrees of freedom of vertices that equations name, by those of the fine space.
    std::map<dealii::types::global_dof_index, dealii::types::global_dof_index> of_equations;
  };

  /// The prolongation from the space of degree one to that of the bodies. Collective.
  template <int dim>
  std::unique_ptr<const Prolongation>
  make_prolongation(const Elasticity<dim> &fine, const LinearSpace<dim> &space);

  /// The diagonal terms of K beyond the stiffness of cells on the next coarser level: the
  /// stabilisation of unconstrained rigid-body modes, distributed to the nodes there, and the terms
  /// of prescribed motions of rigid bodies. Collective.
  /// @param terms of the finer level
  /// @param P prolongation between both levels
  /// @param owned degrees of freedom of the coarser level
  /// @param n_rigid number of degrees of freedom of rigid bodies, the last ones of both levels
  LA::Vector
  restrict_terms(const LA::Vector       &terms,
                 const Prolongation     &P,
                 const dealii::IndexSet &owned,
                 unsigned int            n_rigid);

  /// Constraints at nodes of the bodies that the space of degree one cannot represent: they are
  /// imposed there by penalties of the stiffness of those nodes (doc/theory, 7.1).
  class CoarseConstraintPenalty
  {
  public:
    /// @param diagonal of the bodies' stiffness
    template <int dim>
    CoarseConstraintPenalty(const Elasticity<dim>  &fine,
                            const LinearSpace<dim> &space,
                            const LA::Vector       &diagonal);

    /// True if there are any on any rank. Collective.
    bool
    any() const;

    /// Add the penalties to a matrix whose pattern has the couplings of all cells; the caller
    /// compresses it.
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
