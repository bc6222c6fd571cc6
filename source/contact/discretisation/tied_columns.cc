#include <signorini/contact/discretisation/tied_columns.h>
#include <signorini/row_view.h>

#include <Epetra_CrsMatrix.h>
#include <Epetra_Import.h>
#include <Epetra_Vector.h>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  void
  add_tied_columns(const Elasticity<dim> &elasticity, GapOperator &contact)
  {
    // By how many indices the component goes beyond its node's first one, and by which factors it
    // depends on the others.
    std::vector<LA::Vector> ties(1 + dim, elasticity.zero_vector());
    const auto             &constraints = elasticity.constraints();
    for (const auto &[first, node] : elasticity.held_nodes())
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
    const auto move = [&](const LA::SparseMatrix &from, LA::SparseMatrix &to) {
      const Epetra_CrsMatrix    &matrix = from.trilinos_matrix();
      const Epetra_Import        import(matrix.ColMap(), matrix.DomainMap());
      std::vector<Epetra_Vector> local;
      for (LA::Vector &v : ties)
        {
          v.compress(VectorOperation::insert);
          local.emplace_back(matrix.ColMap());
          local.back().Import(v.trilinos_vector(), import, Insert);
        }
      auto &target = const_cast<Epetra_CrsMatrix &>(to.trilinos_matrix());
      for (int row = 0; row < matrix.NumMyRows(); ++row)
        {
          const RowView view(from, row);
          for (int k = 0; k < view.size; ++k)
            for (unsigned int d = 0; d < dim; ++d)
              if (const double factor = local[1 + d][view.columns[k]]; factor != 0)
                {
                  const auto global = matrix.ColMap().GID64(view.columns[k]) -
                                      static_cast<long long>(local[0][view.columns[k]]) + d;
                  const int column = matrix.ColMap().LID(static_cast<int>(global));
                  double    value  = factor * view.values[k];
                  const int error  = target.SumIntoMyValues(row, 1, &value, &column);
                  AssertThrow(error == 0, ExcTrilinosError(error));
                }
        }
    };
    move(contact.B, contact.B_free);
    if (contact.has_stress())
      move(contact.S, contact.S_free);
  }



  template void
  add_tied_columns(const Elasticity<2> &, GapOperator &);
  template void
  add_tied_columns(const Elasticity<3> &, GapOperator &);
} // namespace Signorini
