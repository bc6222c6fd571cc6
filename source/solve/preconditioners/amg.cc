#include <signorini/row_view.h>
#include <signorini/solve/preconditioners/amg.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>

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

    /// Where each local row goes when those with the same columns, points between the same two
    /// faces, become one.
    std::vector<unsigned int>
    groups_of(const Epetra_CrsMatrix &B)
    {
      std::vector<unsigned int> groups;
      for (int row = 0; row < B.NumMyRows(); ++row)
        {
          const bool is_first = row == 0,
                     is_same  = !is_first && RowView(B, row).has_columns_of(RowView(B, row - 1));
          groups.push_back(is_first ? 0 : groups.back() + (is_same ? 0 : 1));
        }
      return groups;
    }

    /// Each group's mean row, weighted.
    std::shared_ptr<const Epetra_CrsMatrix>
    mean_rows(const Epetra_CrsMatrix          &B,
              const std::vector<unsigned int> &groups,
              const LA::Vector                &weight,
              const LA::Vector                &group_weight)
    {
      const Epetra_Map rows = group_weight.locally_owned_elements().make_trilinos_map(
        group_weight.get_mpi_communicator());
      auto                mean = std::make_shared<Epetra_CrsMatrix>(Copy, rows, 0);
      std::vector<double> sum;
      for (unsigned int first = 0, last = 0; first < groups.size(); first = last)
        {
          int     n, *columns;
          double *values;
          sum.clear();
          for (; last < groups.size() && groups[last] == groups[first]; ++last)
            {
              B.ExtractMyRowView(last, n, values, columns);
              sum.resize(n, 0.);
              for (int k = 0; k < n; ++k)
                sum[k] += weight.trilinos_vector()[0][last] /
                          group_weight.trilinos_vector()[0][groups[first]] * values[k];
            }
          std::vector<int> global(n);
          for (int k = 0; k < n; ++k)
            global[k] = B.GCID(columns[k]);
          mean->InsertGlobalValues(mean->GRID(groups[first]), n, sum.data(), global.data());
        }
      const int error = mean->FillComplete(B.DomainMap(), rows);
      AssertThrow(error == 0, ExcTrilinosError(error));
      return mean;
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

    /// Of absolute values.
    LA::Vector
    sums_of_rows(const Epetra_CrsMatrix &K)
    {
      LA::Vector sums = vector_on(K.RowMap());
      for (int i = 0; i < K.NumMyRows(); ++i)
        {
          const RowView row(K, i);
          for (int k = 0; k < row.size; ++k)
            sums.trilinos_vector()[0][i] += std::abs(row.values[k]);
        }
      return sums;
    }

    /// Something that has all frequencies, times a function that is largest where the rows are
    /// heavy beside their diagonal. There are the few badly shaped cells to which the largest
    /// eigenvalue of the scaled matrix belongs; from a start that is the same everywhere, one among
    /// millions is not found in time.
    LA::Vector
    stiff_oscillation(const LA::Vector &row_sums, const LA::Vector &inverse_diagonal)
    {
      constexpr double power = 16, everywhere = 0.01;
      LA::Vector       result = row_sums;
      result.scale(inverse_diagonal);
      const double  largest = result.linfty_norm();
      const double *inverse = inverse_diagonal.trilinos_vector()[0];
      double       *r       = result.trilinos_vector()[0];
      for (unsigned int i = 0; i < result.locally_owned_size(); ++i)
        r[i] = std::sin(1. + 1.7 * i * i) * (everywhere + std::pow(r[i] / largest, power)) /
               std::sqrt(inverse[i]);
      return result;
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

    enum class Entries
    {
      diagonal,
      all
    };

    /// Adds the diagonal of b^T D b, or the sums of its rows' entries (no less than their absolute
    /// values).
    void
    add_springs(const Epetra_CrsMatrix &b,
                const LA::Vector       &D,
                const Entries           entries,
                LA::Vector             &result)
    {
      Epetra_Vector columns(b.ColMap()), sums(b.DomainMap());
      for (int row = 0; row < b.NumMyRows(); ++row)
        {
          const RowView view(b, row);
          double        sum = 0;
          for (int k = 0; k < view.size; ++k)
            sum += std::abs(view.values[k]);
          for (int k = 0; k < view.size; ++k)
            {
              const double size = std::abs(view.values[k]);
              columns[view.columns[k]] +=
                D.trilinos_vector()[0][row] * size * (entries == Entries::all ? sum : size);
            }
        }
      const int error = sums.Export(columns, Epetra_Import(b.ColMap(), b.DomainMap()), Add);
      AssertThrow(error == 0, ExcTrilinosError(error));
      for (int i = 0; i < sums.MyLength(); ++i)
        result.trilinos_vector()[0][i] += sums[i];
    }
  } // namespace



  AMG::AMG(const Hierarchy &hierarchy, const GapOperator *contact)
    : has_springs(contact && !contact->empty())
  {
    std::shared_ptr<const Epetra_CrsMatrix> B;
    if (has_springs)
      {
        groups                  = groups_of(contact->B_free.trilinos_matrix());
        const unsigned int n    = groups.empty() ? 0 : groups.back() + 1;
        const MPI_Comm     comm = contact->weight.get_mpi_communicator();
        LA::Vector         weight(LA::contiguous_partition(n, comm), comm);
        limit                = weight;
        const double *points = contact->weight.trilinos_vector()[0],
                     *k      = contact->coefficients.stiffness.trilinos_vector()[0];
        for (unsigned int i = 0; i < groups.size(); ++i)
          {
            weight.trilinos_vector()[0][groups[i]] += points[i];
            limit.trilinos_vector()[0][groups[i]] += 6. * k[i] * points[i];
          }
        B = mean_rows(contact->B_free.trilinos_matrix(), groups, contact->weight, weight);
        // With springs everywhere eigenvalues are largest: these bounds hold for any active set.
        D = limit;
      }
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
            level.B = l == 0 ? B : product(*levels[l - 1]->B, hierarchy.prolongation(l - 1));
            level.gap.reinit(limit);
          }
        for (LA::Vector *v :
             {&level.x, &level.right, &level.rest, &level.step, &level.first, &level.force})
          v->reinit(level.diagonal_K);
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
        D         = 0.;
        double *d = D.trilinos_vector()[0];
        for (unsigned int i = 0; i < groups.size(); ++i)
          d[groups[i]] = std::min(d[groups[i]] + springs.trilinos_vector()[0][i],
                                  limit.trilinos_vector()[0][groups[i]]);
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
      add_springs(*level.B, D, Entries::diagonal, level.inverse_diagonal);
    level.inverse_diagonal.trilinos_vector()(0)->Reciprocal(
      *level.inverse_diagonal.trilinos_vector()(0));
  }



  void
  AMG::estimate_eigenvalue(Level &level)
  {
    // By the numbers that conjugate gradients leave behind. (A power iteration of twice as many
    // products underestimates so much that the smoothers may diverge.)
    LA::Vector row_sums = sums_of_rows(*level.K);
    if (has_springs)
      add_springs(*level.B, D, Entries::all, row_sums);
    const LA::Vector right = stiff_oscillation(row_sums, level.inverse_diagonal);
    LA::Vector       x;
    x.reinit(right);
    struct Operator
    {
      const AMG   &amg;
      const Level &level;

      void
      vmult(LA::Vector &dst, const LA::Vector &src) const
      {
        amg.multiply(level, dst, src);
      }
    };
    struct Diagonal
    {
      const LA::Vector &inverse;

      void
      vmult(LA::Vector &dst, const LA::Vector &src) const
      {
        dst = src;
        dst.scale(inverse);
      }
    };
    IterationNumberControl control(10, 1e-10 * right.l2_norm());
    SolverCG<LA::Vector>   cg(control);
    cg.connect_eigenvalues_slot([&level](const std::vector<double> &eigenvalues) {
      level.largest_eigenvalue = eigenvalues.back();
    });
    cg.solve(Operator{*this, level}, x, right, Diagonal{level.inverse_diagonal});
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
