// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "linear_algebra/types.h"
#include "solid/kernel.h"
#include <signorini/materials/material.h>

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/full_matrix.h>

#include <functional>
#include <vector>

namespace Signorini
{
  /// Assembles the stiffness of bodies in a space of displacements, of all cells or some, with
  /// constraints eliminated: rows and columns of constrained degrees of freedom are diagonal.
  /// Refers to all but the model and the index sets.
  template <int dim>
  class StiffnessAssembly
  {
  public:
    using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;

    /// @param dofs of the mesh; `owned` and `relevant` may have more behind them
    StiffnessAssembly(const Mesh<dim>                         &mesh,
                      const std::vector<Material>             &materials,
                      Model                                    model,
                      const dealii::DoFHandler<dim>           &dofs,
                      const dealii::hp::FECollection<dim>     &elements,
                      const dealii::AffineConstraints<double> &constraints,
                      const dealii::IndexSet                  &owned,
                      const dealii::IndexSet                  &relevant);

    /// Assemble K from the locally owned cells for which `takes` is true. The pattern has all
    /// diagonal entries. Collective.
    /// @param K is reinitialised
    void
    assemble(
      LA::SparseMatrix                        &K,
      const std::function<bool(const Cell &)> &takes = [](const Cell &) { return true; }) const;

    /// Assemble K from given cell matrices, such as tangents, instead of those of the undeformed
    /// materials. Collective.
    /// @param matrix_of computes the matrix of a cell, of the size of its degrees of freedom
    void
    assemble(
      LA::SparseMatrix                                                      &K,
      const std::function<bool(const Cell &)>                               &takes,
      const std::function<void(const Cell &, dealii::FullMatrix<double> &)> &matrix_of) const;

  private:
    const Mesh<dim>                         &mesh;
    const std::vector<Material>             &materials;
    const Model                              model;
    const dealii::DoFHandler<dim>           &dofs;
    const dealii::hp::FECollection<dim>     &elements;
    const dealii::AffineConstraints<double> &constraints;
    const dealii::IndexSet                   owned, relevant;
  };
} // namespace Signorini
