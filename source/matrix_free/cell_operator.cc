// SPDX-License-Identifier: Apache-2.0
#include "matrix_free/cell_operator.h"

#include "linear_algebra/values.h"

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The node lists of the cells of each degree.
    std::vector<const std::vector<std::uint32_t> *>
    nodes_of(const CellSpace &space)
    {
      std::vector<const std::vector<std::uint32_t> *> result;
      for (const KernelCells &cells : space.cells)
        result.push_back(&cells.nodes);
      return result;
    }

    /// A kernel for cells whose nodes are renumbered to the local arrays.
    template <typename Number>
    std::unique_ptr<CellKernel<Number>>
    make_kernel(KernelCells cells, const LocalVectors<Number> &vectors)
    {
      for (std::uint32_t &node : cells.nodes)
        node = vectors.local_index(node);
      return CellKernel<Number>::create(cells);
    }
  } // namespace



  template <typename Number>
  CellOperator<Number>::CellOperator(const CellSpace &space)
    : my_owned(space.owned)
    , comm(space.comm)
    , vectors(space.owned, nodes_of(space), space.constraints, space.comm)
  {
    update(space);
  }



  // Make the kernels of a space with the same degrees of freedom, and the diagonal: sum of the
  // cells' diagonals with constraints condensed, plus the given diagonal terms.
  template <typename Number>
  void
  CellOperator<Number>::update(const CellSpace &space)
  {
    kernels.clear();
    for (const KernelCells &cells : space.cells)
      kernels.push_back(make_kernel(cells, vectors));
    // Terms are what the operator adds to the product of the cells, as pairs of index and diagonal
    // entry; most degrees of freedom have none.
    terms.clear();
    Number *const d = vectors.zero();
    for (const auto &kernel : kernels)
      kernel->add_diagonal(d);
    const Number *const sums = vectors.condense_diagonal();
    my_diagonal.assign(sums, sums + my_owned.n_elements());
    const double *const beyond = LA::values_of(space.diagonal_terms);
    for (std::size_t i = 0; i < my_diagonal.size(); ++i)
      my_diagonal[i] += beyond[i];
    // The product of the cells is zero at constrained degrees of freedom; there the operator is its
    // diagonal, as an assembled matrix with constraints eliminated is.
    std::vector<bool> is_constrained(my_diagonal.size(), false);
    for (const auto i : vectors.owned_constrained())
      is_constrained[i] = true;
    for (std::size_t i = 0; i < my_diagonal.size(); ++i)
      if (is_constrained[i])
        terms.emplace_back(i, my_diagonal[i]);
      else if (beyond[i] != 0)
        terms.emplace_back(i, beyond[i]);
  }



  // y = C^T K_cells C x + diagonal terms (doc/theory, 7.9). Collective: ghost values are fetched
  // before, and added to their owners after.
  template <typename Number>
  Number *
  CellOperator<Number>::product(const Number *x) const
  {
    const Number *const u = vectors.resolve(x);
    Number *const       f = vectors.zero();
    for (const auto &kernel : kernels)
      kernel->add_product(f, u);
    Number *const y = vectors.condense();
    for (const auto &[i, term] : terms)
      y[i] += term * x[i];
    return y;
  }



  // Estimate of the l1 norms: the diagonal times the largest eigenvalue of diag(K_e)^-1 K_e of the
  // cells around. Rigid bodies have no cells and get their diagonal.
  template <typename Number>
  std::vector<Number>
  CellOperator<Number>::row_l1_norms() const
  {
    // Gershgorin's sums need the entries of the matrix. For a sum of cell matrices, the largest
    // eigenvalue of D^-1 K is at most the largest one of D_e^-1 K_e over its cells, which needs no
    // matrix.
    Number *const largest = vectors.zero();
    for (const auto &kernel : kernels)
      kernel->enlarge_by_eigenvalues(largest);
    const Number *const ratios = vectors.largest();
    std::vector<Number> result = my_diagonal;
    for (std::size_t i = 0; i < result.size(); ++i)
      result[i] *= std::max(ratios[i], Number(1));
    return result;
  }



  template class CellOperator<float>;
  template class CellOperator<double>;
} // namespace Signorini
