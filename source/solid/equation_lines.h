// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/constrained_nodes.h"
#include <signorini/solid/constraint_equations.h>

#include <deal.II/base/index_set.h>

#include <utility>
#include <vector>

namespace Signorini
{
  /// Constraint equations on a mesh, solved for one degree of freedom each. Equations are few: all
  /// ranks have all of them, with their nodes.
  template <int dim>
  class EquationLines
  {
  public:
    /// @param sets the equations
    explicit EquationLines(const std::vector<ConstraintEquations<dim>> &sets);

    /// True if there are no equations.
    bool
    empty() const
    {
      return sets.empty();
    }

    /// Find the nodes of the equations. In cells of degree two the middles of faces, which mesh
    /// files do not have, follow the others as in elements of 20 nodes, where all of these are in
    /// equations: then the equations hold on the whole face. Throws SceneError on all ranks where
    /// one does not exist, or hangs. Collective.
    void
    find_nodes(const Mesh<dim>                         &mesh,
               const dealii::DoFHandler<dim>           &dofs,
               const dealii::AffineConstraints<double> &hanging);

    /// The nodes of all equations, by their first degree of freedom, the same on all ranks.
    const ConstrainedNodes<dim> &
    nodes() const
    {
      return my_nodes;
    }

    /// A factor times a component of the displacement of a node.
    struct Term
    {
      const ConstrainedNode<dim> *node;
      unsigned int                component;
      double                      factor;
    };

    /// The terms of all equations.
    std::vector<std::vector<Term>>
    terms() const;

    /// The degrees of freedom of the nodes, all components.
    std::vector<dealii::types::global_dof_index>
    dofs() const;

    /// Add a line for each independent equation to constraints that contain those of supports and
    /// hanging nodes, and are not closed. Degrees of freedom that these constrain are eliminated.
    /// Throws SceneError on all ranks for equations that contradict the others, or supports, at
    /// time t. Collective.
    /// @param owned degrees of freedom of this rank
    void
    add_to(dealii::AffineConstraints<double> &constraints,
           const dealii::IndexSet            &owned,
           double                             t,
           MPI_Comm                           comm) const;

  private:
    /// sum_k a_k u_k = b.
    struct Equation
    {
      std::vector<std::pair<dealii::types::global_dof_index, double>> terms;
      double                                                          value;
    };

    void
    add_node(const std::vector<dealii::types::global_dof_index> &dofs,
             const std::vector<double>                          &position,
             unsigned int                                        piece);
    void
    find_middles_of_faces(const Mesh<dim> &mesh, const dealii::DoFHandler<dim> &dofs);
    void
    exchange_lines(dealii::AffineConstraints<double> &constraints,
                   const dealii::IndexSet            &owned,
                   MPI_Comm                           comm) const;

    const std::vector<ConstraintEquations<dim>> sets;
    /// For each set and equation the first degrees of freedom of the nodes of its terms.
    std::vector<std::vector<std::vector<dealii::types::global_dof_index>>> first_dofs;
    ConstrainedNodes<dim>                                                  my_nodes;
    /// The equations of middles of faces, the first term of each.
    std::vector<Equation> of_middles;
  };
} // namespace Signorini
