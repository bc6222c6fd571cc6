#include <signorini/solve/preconditioners/amg.h>

#include <deal.II/lac/full_matrix.h>

#include <Amesos.h>
#include <Amesos_BaseSolver.h>
#include <EpetraExt_MatrixMatrix.h>
#include <Epetra_CrsMatrix.h>
#include <Epetra_FECrsMatrix.h>
#include <Epetra_Import.h>
#include <Epetra_LinearProblem.h>
#include <Epetra_MpiComm.h>
#include <Epetra_Vector.h>

#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    LA::Vector
    vector_on(const Epetra_BlockMap &map)
    {
      const auto *comm = dynamic_cast<const Epetra_MpiComm *>(&map.Comm());
      return LA::Vector(IndexSet(static_cast<const Epetra_Map &>(map)), comm->Comm());
    }

    void
    apply(const Epetra_CrsMatrix &matrix,
          const bool              transpose,
          const LA::Vector       &src,
          LA::Vector             &dst)
    {
      const int error = matrix.Multiply(transpose, src.trilinos_vector(), dst.trilinos_vector());
      AssertThrow(error == 0, ExcTrilinosError(error));
    }

    std::unique_ptr<Epetra_CrsMatrix>
    product(const Epetra_CrsMatrix &a, const Epetra_CrsMatrix &b)
    {
      auto      c     = std::make_unique<Epetra_CrsMatrix>(Copy, a.RowMap(), 0);
      const int error = EpetraExt::MatrixMatrix::Multiply(a, false, b, false, *c);
      AssertThrow(error == 0, ExcTrilinosError(error));
      return c;
    }

    /// b^T D b on the columns of this rank, for the coarsest level, which has few.
    FullMatrix<double>
    local_springs(const Epetra_CrsMatrix &b, const LA::Vector &D)
    {
      FullMatrix<double> springs(b.NumMyCols());
      for (int row = 0; row < b.NumMyRows(); ++row)
        {
          const double spring = D.trilinos_vector()[0][row];
          if (spring == 0)
            continue;
          int     n, *indices;
          double *values;
          b.ExtractMyRowView(row, n, values, indices);
          for (int k = 0; k < n; ++k)
            for (int l = 0; l < n; ++l)
              springs(indices[k], indices[l]) += spring * values[k] * values[l];
        }
      return springs;
    }

    /// K + b^T D b
    std::unique_ptr<Epetra_CrsMatrix>
    with_springs(const Epetra_CrsMatrix &K, const Epetra_CrsMatrix &b, const LA::Vector &D)
    {
      auto sum = std::make_unique<Epetra_FECrsMatrix>(Copy, K.RowMap(), 0);
      for (int row = 0; row < K.NumMyRows(); ++row)
        {
          int     n, *indices;
          double *values;
          K.ExtractMyRowView(row, n, values, indices);
          for (int k = 0; k < n; ++k)
            sum->InsertGlobalValues(K.GRID(row),
                                    1,
                                    &values[k],
                                    &K.ColMap().MyGlobalElements()[indices[k]]);
        }
      const FullMatrix<double> springs = local_springs(b, D);
      const int               *columns = b.ColMap().MyGlobalElements();
      for (unsigned int i = 0; i < springs.m(); ++i)
        for (unsigned int j = 0; j < springs.n(); ++j)
          if (springs(i, j) != 0)
            sum->InsertGlobalValues(1, &columns[i], 1, &columns[j], &springs(i, j));
      const int error = sum->GlobalAssemble(K.DomainMap(), K.RangeMap());
      AssertThrow(error == 0, ExcTrilinosError(error));
      return sum;
    }

    /// diagonal += diag(b^T D b)
    void
    add_spring_diagonal(const Epetra_CrsMatrix &b, const LA::Vector &D, LA::Vector &diagonal)
    {
      Epetra_Vector columns(b.ColMap()), sums(b.DomainMap());
      for (int row = 0; row < b.NumMyRows(); ++row)
        {
          int     n, *indices;
          double *values;
          b.ExtractMyRowView(row, n, values, indices);
          for (int k = 0; k < n; ++k)
            columns[indices[k]] += D.trilinos_vector()[0][row] * values[k] * values[k];
        }
      const int error = sums.Export(columns, Epetra_Import(b.ColMap(), b.DomainMap()), Add);
      AssertThrow(error == 0, ExcTrilinosError(error));
      for (int i = 0; i < sums.MyLength(); ++i)
        diagonal.trilinos_vector()[0][i] += sums[i];
    }
  } // namespace



  AMG::AMG(const Hierarchy &hierarchy, const GapOperator *contact)
    : has_springs(contact && !contact->empty())
  {
    for (unsigned int l = 0; l < hierarchy.n_levels(); ++l)
      {
        levels.push_back(std::make_unique<Level>());
        Level &level     = *levels.back();
        level.K          = &hierarchy.matrix(l);
        level.diagonal_K = vector_on(level.K->RowMap());
        Epetra_Vector diagonal(level.K->RowMap());
        level.K->ExtractDiagonalCopy(diagonal);
        std::copy_n(diagonal.Values(), diagonal.MyLength(), level.diagonal_K.trilinos_vector()[0]);
        if (l + 1 < hierarchy.n_levels())
          level.P = &hierarchy.prolongation(l);
        if (has_springs)
          {
            if (l == 0) // not ours
              level.B = std::shared_ptr<const Epetra_CrsMatrix>(&contact->B_free.trilinos_matrix(),
                                                                [](const Epetra_CrsMatrix *) {});
            else
              level.B = product(*levels[l - 1]->B, hierarchy.prolongation(l - 1));
            level.gap = contact->zero();
          }
        for (LA::Vector *v :
             {&level.x, &level.right, &level.rest, &level.step, &level.first, &level.force})
          v->reinit(level.diagonal_K);
      }
    if (has_springs)
      {
        // With springs everywhere eigenvalues are largest: these bounds hold for any active set.
        limit = contact->weight;
        limit.scale(contact->stiffness);
        limit *= 6.;
        D = limit;
      }
    for (auto &level : levels)
      {
        update_diagonal(*level);
        if (level->P)
          estimate_eigenvalue(*level);
      }
    if (has_springs)
      D = 0.;
    for (auto &level : levels)
      update_diagonal(*level);
    factorise();
  }



  AMG::~AMG() = default;



  void
  AMG::set_springs(const LA::Vector &springs)
  {
    if (has_springs)
      {
        for (const auto i : D.locally_owned_elements())
          D(i) = std::min<double>(springs(i), limit(i));
        D.compress(VectorOperation::insert);
      }
    for (auto &level : levels)
      update_diagonal(*level);
    factorise();
  }



  void
  AMG::update_diagonal(Level &level)
  {
    level.inverse_diagonal = level.diagonal_K;
    if (has_springs)
      add_spring_diagonal(*level.B, D, level.inverse_diagonal);
    level.inverse_diagonal.trilinos_vector()(0)->Reciprocal(
      *level.inverse_diagonal.trilinos_vector()(0));
  }



  void
  AMG::estimate_eigenvalue(Level &level)
  {
    // Power iteration, from something that has all frequencies.
    LA::Vector v, w;
    v.reinit(level.diagonal_K);
    w.reinit(level.diagonal_K);
    double *values = v.trilinos_vector()[0];
    for (unsigned int i = 0; i < v.locally_owned_size(); ++i)
      values[i] = std::sin(1. + 1.7 * i * i);
    for (unsigned int n = 0; n < 20; ++n)
      {
        v /= v.l2_norm();
        multiply(level, w, v);
        w.scale(level.inverse_diagonal);
        level.largest_eigenvalue = w.l2_norm();
        v                        = w;
      }
  }



  void
  AMG::factorise()
  {
    const Level &last = *levels.back();
    direct.reset();
    coarsest.reset();
    if (has_springs && D.linfty_norm() > 0)
      coarsest = with_springs(*last.K, *last.B, D);
    problem = std::make_unique<Epetra_LinearProblem>();
    problem->SetOperator(coarsest ? coarsest.get() : const_cast<Epetra_CrsMatrix *>(last.K));
    direct.reset(Amesos().Create("Amesos_Klu", *problem));
    int error = direct->SymbolicFactorization();
    if (error == 0)
      error = direct->NumericFactorization();
    AssertThrow(error == 0, ExcTrilinosError(error));
  }



  void
  AMG::multiply(const Level &level, LA::Vector &dst, const LA::Vector &src) const
  {
    apply(*level.K, false, src, dst);
    if (!has_springs)
      return;
    apply(*level.B, false, src, level.gap);
    level.gap.scale(D);
    apply(*level.B, true, level.gap, level.force);
    dst += level.force;
  }



  void
  AMG::smooth(const Level      &level,
              LA::Vector       &x,
              const LA::Vector &right,
              const bool        from_zero) const
  {
    // Chebyshev polynomial of second degree on the upper part of the spectrum (Saad, Iterative
    // Methods for Sparse Linear Systems, algorithm 12.1).
    const double largest = 1.1 * level.largest_eigenvalue, smallest = largest / 20;
    const double theta = (largest + smallest) / 2, delta = (largest - smallest) / 2;
    const double sigma = theta / delta;
    double       rho   = 1 / sigma;

    level.rest = right;
    if (from_zero)
      x = 0;
    else
      {
        multiply(level, level.rest, x);
        level.rest.sadd(-1, 1, right);
      }
    level.step = level.rest;
    level.step.scale(level.inverse_diagonal);
    level.step /= theta;
    x += level.step;

    multiply(level, level.rest, x);
    level.rest.sadd(-1, 1, right);
    level.rest.scale(level.inverse_diagonal);
    const double next = 1 / (2 * sigma - rho);
    level.step *= next * rho;
    level.step.add(2 * next / delta, level.rest);
    x += level.step;
  }



  void
  AMG::cycle(const unsigned int l, LA::Vector &x, const LA::Vector &right) const
  {
    const Level &level = *levels[l];
    if (!level.P)
      {
        problem->SetLHS(&x.trilinos_vector());
        problem->SetRHS(const_cast<Epetra_MultiVector *>(&right.trilinos_vector()));
        const int error = direct->Solve();
        AssertThrow(error == 0, ExcTrilinosError(error));
        return;
      }
    smooth(level, x, right, true);
    multiply(level, level.rest, x);
    level.rest.sadd(-1, 1, right);
    const Level &next = *levels[l + 1];
    apply(*level.P, true, level.rest, next.right);
    cycle(l + 1, next.x, next.right);
    if (next.P) // a W-cycle: what is left, once more
      {
        next.first = next.x;
        multiply(next, next.rest, next.first);
        next.right -= next.rest;
        cycle(l + 1, next.x, next.right);
        next.x += next.first;
      }
    apply(*level.P, false, next.x, level.rest);
    x += level.rest;
    smooth(level, x, right, false);
  }



  void
  AMG::vmult(LA::Vector &dst, const LA::Vector &src) const
  {
    ++n_cycles;
    cycle(0, dst, src);
  }
} // namespace Signorini
