#pragma once

#include <signorini/elasticity/elasticity.h>

#include <utility>
#include <vector>

namespace Signorini
{
  using SparseRow = std::vector<std::pair<dealii::types::global_dof_index, double>>;

  /// Sum entries of the same index.
  void
  unite(SparseRow &row);

  /// Replace hanging nodes by the nodes that they hang on. Sorts and unites a row that has any.
  void
  resolve(const dealii::AffineConstraints<double> &hanging, SparseRow &row);

  /// row . u of each, whose degrees of freedom may be on other ranks. Collective.
  /// @param u without ghosts
  std::vector<double>
  row_values(const std::vector<const SparseRow *> &rows, const LA::Vector &u);

  /// Shape functions of a cell at points of one of its faces, in terms of degrees of freedom
  /// (hanging nodes resolved). Keeps a reference to its argument.
  template <int dim>
  class Trace
  {
  public:
    using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;

    Trace(const Elasticity<dim> &elasticity);

    void
    reinit(const Cell &cell, unsigned int face);

    /// n . u at a point of the face, given on the reference cell.
    SparseRow
    normal_displacement(const dealii::Point<dim>     &unit_point,
                        const dealii::Tensor<1, dim> &n) const;

    /// The derivative of n . u in parameter a of the face.
    SparseRow
    normal_slope(const dealii::Point<dim>     &unit_point,
                 const dealii::Tensor<1, dim> &n,
                 unsigned int                  a) const;

    /// The scalar shape functions, each named by its node's first degree of freedom.
    SparseRow
    shape(const dealii::Point<dim> &unit_point) const;

    /// The same with hanging nodes as they are.
    SparseRow
    unresolved_shape(const dealii::Point<dim> &unit_point) const;

  private:
    const std::vector<unsigned int> &
    nodes() const;

    const dealii::AffineConstraints<double> &hanging;
    const bool all_components; ///< supports may tie those along the normal to the others
    std::vector<std::vector<std::vector<unsigned int>>> nodes_of; ///< [element][face of a cell]

    // Of the present face.
    const dealii::FiniteElement<dim>            *fe = nullptr;
    std::vector<dealii::types::global_dof_index> indices;
    unsigned int                                 element = 0, face = 0;
  };
} // namespace Signorini
