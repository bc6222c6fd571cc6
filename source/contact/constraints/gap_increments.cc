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



  namespace
  {
    /// Fetch the displacements of the nodes of points. Collective.
    /// @param others further degrees of freedom
    template <int dim>
    VectorValues
    values_at_nodes(const std::vector<const ContactPoint<dim> *> &points,
                    const LA::Vector                             &u,
                    const std::vector<types::global_dof_index>   &others)
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
        }
      // Only the first degrees of freedom of nodes are sorted, a third of all in space; the other
      // components follow afterwards.
      std::sort(indices.begin(), indices.end());
      indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
      for (std::size_t i = 0, n = indices.size(); i < n; ++i)
        for (unsigned int d = 1; d < dim; ++d)
          indices.push_back(indices[i] + d);
      indices.insert(indices.end(), others.begin(), others.end());
      return {u, std::move(indices)};
    }
  } // namespace



  // (u^S - u^M) . n at each point, from shape functions and nodal values, without assembling rows.
  template <int dim>
  std::vector<double>
  gap_increments(const std::vector<const ContactPoint<dim> *> &points, const LA::Vector &u)
  {
    std::vector<types::global_dof_index> rigid;
    for (const ContactPoint<dim> *point : points)
      for (const auto &entry : point->rigid)
        rigid.push_back(entry.first);
    const VectorValues value = values_at_nodes(points, u, rigid);

    std::vector<double> result;
    for (const ContactPoint<dim> *point : points)
      result.push_back(value_at(point->slave, value) * point->direction -
                       value_at(point->master, value) * point->on_master(point->direction) -
                       value(point->rigid));
    return result;
  }



  template <int dim>
  std::vector<Tensor<1, dim>>
  relative_displacements(const std::vector<const ContactPoint<dim> *> &points,
                         const std::vector<const SurfaceFrame<dim> *> &frames,
                         const LA::Vector                             &u)
  {
    std::vector<types::global_dof_index> rigid;
    for (const SurfaceFrame<dim> *frame : frames)
      for (const SparseRow &component : frame->rigid_motion)
        for (const auto &entry : component)
          rigid.push_back(entry.first);
    const VectorValues value = values_at_nodes(points, u, rigid);

    std::vector<Tensor<1, dim>> result;
    for (unsigned int q = 0; q < points.size(); ++q)
      {
        const ContactPoint<dim> &point     = *points[q];
        const Tensor<1, dim>     of_master = value_at(point.master, value);
        result.push_back(value_at(point.slave, value) -
                         (point.turn ? *point.turn * of_master : of_master));
        for (unsigned int d = 0; d < dim; ++d)
          result.back()[d] -= value(frames[q]->rigid_motion[d]);
      }
    return result;
  }



  template std::vector<Tensor<1, 2>>
  relative_displacements(const std::vector<const ContactPoint<2> *> &,
                         const std::vector<const SurfaceFrame<2> *> &,
                         const LA::Vector &);
  template std::vector<Tensor<1, 3>>
  relative_displacements(const std::vector<const ContactPoint<3> *> &,
                         const std::vector<const SurfaceFrame<3> *> &,
                         const LA::Vector &);
  template std::vector<double>
  gap_increments(const std::vector<const ContactPoint<2> *> &, const LA::Vector &);
  template std::vector<double>
  gap_increments(const std::vector<const ContactPoint<3> *> &, const LA::Vector &);
} // namespace Signorini
