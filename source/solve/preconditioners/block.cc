#include <signorini/solve/preconditioners/block.h>

#include <Epetra_CrsMatrix.h>
#include <Epetra_Import.h>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// diag(B diag(K)^-1 B^T)
    LA::Vector
    point_flexibility(const LA::SparseMatrix &K, const GapOperator &contact)
    {
      const Epetra_CrsMatrix &B = contact.B_free.trilinos_matrix();
      Epetra_Vector           diagonal(K.trilinos_matrix().RowMap()), columns(B.ColMap());
      K.trilinos_matrix().ExtractDiagonalCopy(diagonal);
      columns.Import(diagonal, Epetra_Import(B.ColMap(), B.DomainMap()), Insert);

      LA::Vector flexibility = contact.zero();
      int        local       = 0;
      for (const auto i : flexibility.locally_owned_elements())
        {
          int     n, *indices;
          double *values, sum = 0;
          B.ExtractMyRowView(local++, n, values, indices);
          for (int k = 0; k < n; ++k)
            sum += values[k] * values[k] / columns[indices[k]];
          flexibility(i) = sum;
        }
      flexibility.compress(VectorOperation::insert);
      return flexibility;
    }
  } // namespace



  BlockPreconditioner::BlockPreconditioner(const ContactSystem &system,
                                           const AMG           &amg,
                                           const bool           triangular)
    : system(system)
    , amg(amg)
    , triangular(triangular)
  {
    if (system.is_saddle_point())
      flexibility = point_flexibility(system.stiffness(), system.gap_operator());
  }



  void
  BlockPreconditioner::update()
  {
    if (!system.is_saddle_point())
      return;
    inverse_schur = system.gap_operator().zero();
    for (const auto i : inverse_schur.locally_owned_elements())
      {
        const double A   = system.coupling()(i);
        inverse_schur(i) = 1 / (A * A * flexibility(i) + system.identity()(i));
      }
    inverse_schur.compress(VectorOperation::insert);
  }



  void
  BlockPreconditioner::vmult(LA::BlockVector &dst, const LA::BlockVector &src) const
  {
    amg.vmult(dst.block(0), src.block(0));
    if (!system.is_saddle_point())
      return;
    dst.block(1) = src.block(1);
    if (triangular)
      {
        // [K 0; -A B  -S]: the second row sees what the first has found, and S counts negative.
        rest.reinit(src.block(1));
        system.gap_operator().B_free.vmult(rest, dst.block(0));
        rest.scale(system.coupling());
        dst.block(1) += rest;
        dst.block(1) *= -1;
      }
    dst.block(1).scale(inverse_schur);
  }
} // namespace Signorini
