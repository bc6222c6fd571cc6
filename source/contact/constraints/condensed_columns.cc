// SPDX-License-Identifier: Apache-2.0
#include "contact/constraints/condensed_columns.h"

#include "linear_algebra/columns.h"
#include "linear_algebra/entries.h"
#include "linear_algebra/row_view.h"

namespace Signorini
{
  using namespace dealii;

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
        if (const auto line = node.dofs[d];
            elasticity.owned().is_element(line) && constraints.is_constrained(line))
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



  template void
  add_condensed_columns(const Elasticity<2> &, GapOperator &);
  template void
  add_condensed_columns(const Elasticity<3> &, GapOperator &);
} // namespace Signorini
