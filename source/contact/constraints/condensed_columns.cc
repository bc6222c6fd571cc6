// SPDX-License-Identifier: Apache-2.0
#include "contact/constraints/condensed_columns.h"

#include "linear_algebra/columns.h"
#include "linear_algebra/entries.h"
#include "linear_algebra/row_view.h"

#include <algorithm>
#include <iterator>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The constraint of a degree of freedom at a node of constraint equations, which all ranks
    /// know; null where there is none. In vectors the components of a node follow each other.
    template <int dim>
    const std::vector<std::pair<types::global_dof_index, double>> *
    line_at_equations(const Elasticity<dim> &elasticity, const types::global_dof_index dof)
    {
      const ConstrainedNodes<dim> &nodes = elasticity.nodes_of_equations();
      const auto                   next  = nodes.upper_bound(dof);
      if (next == nodes.begin())
        return nullptr;
      const auto &of_node = std::prev(next)->second.dofs;
      return std::find(of_node.begin(), of_node.end(), dof) == of_node.end() ?
               nullptr :
               elasticity.constraints().get_constraint_entries(dof);
    }
  } // namespace



  template <int dim>
  std::vector<types::global_dof_index>
  columns_by_equations(const Elasticity<dim>                      &elasticity,
                       const std::vector<types::global_dof_index> &columns)
  {
    std::vector<types::global_dof_index> result;
    if (!elasticity.nodes_of_equations().empty())
      for (const auto dof : columns)
        if (const auto *line = line_at_equations(elasticity, dof))
          for (const auto &entry : *line)
            result.push_back(entry.first);
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }



  template <int dim>
  void
  add_condensed_columns(const Elasticity<dim> &elasticity, GapOperator &contact)
  {
    // For each constrained component on its owner: its number within the node (entry 0), and the
    // factors by which it depends on the components of the node (entries 1 to dim). As vectors,
    // they can be fetched for the columns of other ranks.
    std::vector<LA::Vector> ties(1 + dim, elasticity.zero_vector());
    const auto             &constraints = elasticity.constraints();
    for (const auto &[first, node] : elasticity.constrained_nodes())
      for (unsigned int d = 0; d < dim; ++d)
        if (const auto line = node.dofs[d]; elasticity.owned().is_element(line) &&
                                            constraints.is_constrained(line) &&
                                            !line_at_equations(elasticity, line))
          for (const auto &[other, factor] : *constraints.get_constraint_entries(line))
            {
              AssertThrow(node.dofs[d] == first + d && other >= first && other < first + dim,
                          ExcMessage("degrees of freedom of a node are not consecutive"));
              ties[0](line)                 = d;
              ties[1 + other - first](line) = factor;
            }
    for (LA::Vector &v : ties)
      v.compress(VectorOperation::insert);
    // Add the entries of a condensed column to the columns on which it depends: B_free = B C for
    // the constraints u = C u_free. Collective.
    const auto move = [&](const LA::SparseMatrix &from, LA::SparseMatrix &to) {
      const LA::ColumnExchange         columns(from);
      const auto                       global = LA::global_columns(from);
      std::vector<std::vector<double>> local;
      for (const LA::Vector &v : ties)
        local.push_back(columns.fetch(v));
      const int n_rows = contact.weight.locally_owned_size();
      for (int row = 0; row < n_rows; ++row)
        {
          const LA::RowView view(from, row);
          for (int k = 0; k < view.size; ++k)
            if (const auto *line = line_at_equations(elasticity, global[view.columns[k]]))
              {
                for (const auto &[other, factor] : *line)
                  if (view.values[k] != 0)
                    LA::add_to_entry(to, row, other, factor * view.values[k]);
              }
            else
              for (unsigned int d = 0; d < dim; ++d)
                if (const double factor = local[1 + d][view.columns[k]]; factor != 0)
                  {
                    const auto offset =
                      static_cast<types::global_dof_index>(local[0][view.columns[k]]);
                    LA::add_to_entry(to,
                                     row,
                                     global[view.columns[k]] - offset + d,
                                     factor * view.values[k]);
                  }
        }
    };
    move(contact.B, contact.B_free);
    for (unsigned int a = 0; a < contact.tangential.B.size(); ++a)
      move(contact.tangential.B[a], contact.tangential.B_free[a]);
    for (unsigned int a = 0; a < contact.S.size(); ++a)
      move(contact.S[a], contact.S_free[a]);
  }



#define INSTANTIATE(dim)                                                                           \
  template std::vector<types::global_dof_index> columns_by_equations(                              \
    const Elasticity<dim> &, const std::vector<types::global_dof_index> &);                        \
  template void add_condensed_columns(const Elasticity<dim> &, GapOperator &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
