#include <signorini/linear_algebra/values.h>
#include <signorini/matrix_free/cell_operator.h>

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    std::vector<const std::vector<std::uint32_t> *>
    nodes_of(const CellSpace &space)
    {
      std::vector<const std::vector<std::uint32_t> *> result;
      for (const KernelCells &cells : space.cells)
        result.push_back(&cells.nodes);
      return result;
    }

    template <typename Number>
    std::unique_ptr<CellKernel<Number>>
    make_kernel(KernelCells cells, const LocalVectors<Number> &vectors)
    {
      for (std::uint32_t &node : cells.nodes)
        node = vectors.place(node);
      return CellKernel<Number>::create(cells);
    }
  } // namespace



  template <typename Number>
  CellOperator<Number>::CellOperator(const CellSpace &space)
    : my_owned(space.owned)
    , vectors(space.owned, nodes_of(space), space.constraints, space.comm)
    , my_diagonal(space.owned, space.comm)
    , terms(space.diagonal_terms)
  {
    for (const KernelCells &cells : space.cells)
      kernels.push_back(make_kernel(cells, vectors));
    make_diagonal(space);
  }



  template <typename Number>
  void
  CellOperator<Number>::make_diagonal(const CellSpace &space)
  {
    Number *const d = vectors.zero();
    for (const auto &kernel : kernels)
      kernel->add_diagonal(d);
    add_tied_diagonal(space, [&](const types::global_dof_index dof, const double value) {
      d[vectors.place(dof)] += value;
    });
    vectors.sum(my_diagonal);
    my_diagonal += terms;
    double *const t = LA::values_of(terms);
    for (const auto i : vectors.owned_constrained())
      t[i] = LA::values_of(my_diagonal)[i];
  }



  template <typename Number>
  void
  CellOperator<Number>::vmult(LA::Vector &dst, const LA::Vector &src) const
  {
    const Number *const u = vectors.resolve(src);
    Number *const       f = vectors.zero();
    for (const auto &kernel : kernels)
      kernel->add_product(f, u);
    vectors.condense(dst);
    double *const       y = LA::values_of(dst);
    const double *const x = LA::values_of(src), *const t = LA::values_of(terms);
    for (unsigned int i = 0; i < dst.locally_owned_size(); ++i)
      y[i] += t[i] * x[i];
  }



  template <typename Number>
  LA::Vector
  CellOperator<Number>::row_sizes() const
  {
    Number *const largest = vectors.zero();
    for (const auto &kernel : kernels)
      kernel->enlarge_by_eigenvalues(largest);
    LA::Vector result;
    result.reinit(my_diagonal, true);
    vectors.largest(result);
    double *const r = LA::values_of(result);
    for (unsigned int i = 0; i < result.locally_owned_size(); ++i)
      r[i] = std::max(r[i], 1.) * LA::values_of(my_diagonal)[i]; // rigid bodies have no cells
    return result;
  }



  template <typename Number>
  std::size_t
  CellOperator<Number>::memory() const
  {
    std::size_t bytes = vectors.memory() + 2 * sizeof(double) * my_diagonal.locally_owned_size();
    for (const auto &kernel : kernels)
      bytes += kernel->memory();
    return bytes;
  }



  template class CellOperator<float>;
  template class CellOperator<double>;
} // namespace Signorini
