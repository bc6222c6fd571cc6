// SPDX-License-Identifier: Apache-2.0
#include "contact/constraints/gap_increments.h"

#include <deal.II/base/exceptions.h>

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  VectorValues::VectorValues(const LA::Vector &u, std::vector<types::global_dof_index> all)
    : indices(std::move(all))
  // Fetch the entries u(all) from their owners once, sorted for binary search. Collective.
  {
    std::sort(indices.begin(), indices.end());
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
    IndexSet readable = u.locally_owned_elements();
    readable.add_indices(indices.begin(), indices.end());
    LA::Vector ghosted(u.locally_owned_elements(), readable, u.get_mpi_communicator());
    ghosted = u;
    values.resize(indices.size());
    ghosted.extract_subvector_to(indices, values);
  }



  double
  VectorValues::operator()(const types::global_dof_index index) const
  {
    const auto at = std::lower_bound(indices.begin(), indices.end(), index);
    Assert(at != indices.end() && *at == index, ExcInternalError());
    return values[at - indices.begin()];
  }



  double
  VectorValues::operator()(const SparseRow &row) const
  {
    double sum = 0;
    for (const auto &[index, value] : row)
      sum += value * (*this)(index);
    return sum;
  }



  // (u^S - u^M) . n at each point, from shape functions and nodal values, without assembling rows.
  template <int dim>
  std::vector<double>
  gap_increments(const std::vector<const ContactPoint<dim> *> &points, const LA::Vector &u)
  {
    std::vector<types::global_dof_index> indices;
    const ContactPoint<dim>             *before = nullptr;
    // Nodes of consecutive points are mostly the same; they are collected once.
    for (const ContactPoint<dim> *point : points)
      {
        if (before == nullptr || !same_nodes(*before, *point))
          for (const auto *functions : {&point->slave, &point->master})
            for (const NodeShapeFunction<dim> &function : *functions)
              indices.push_back(function.node);
        before = point;
        for (const auto &entry : point->rigid)
          indices.push_back(entry.first);
      }
    // Only the first degrees of freedom of nodes are sorted, a third of all in space; the other
    // components follow afterwards.
    std::sort(indices.begin(), indices.end());
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
    for (std::size_t i = 0, n = indices.size(); i < n; ++i)
      for (unsigned int d = 1; d < dim; ++d)
        if (indices[i] + d < u.size())
          indices.push_back(indices[i] + d);
    const VectorValues value(u, std::move(indices));

    std::vector<double> result;
    for (const ContactPoint<dim> *point : points)
      result.push_back(value_at(point->slave, value) * point->direction -
                       value_at(point->master, value) * point->on_master(point->direction) -
                       value(point->rigid));
    return result;
  }



  template std::vector<double>
  gap_increments(const std::vector<const ContactPoint<2> *> &, const LA::Vector &);
  template std::vector<double>
  gap_increments(const std::vector<const ContactPoint<3> *> &, const LA::Vector &);
} // namespace Signorini
