// SPDX-License-Identifier: Apache-2.0
#include "linear_algebra/direct_solver.h"

#include <Amesos.h>
#include <Amesos_BaseSolver.h>
#include <Epetra_CrsMatrix.h>
#include <Epetra_LinearProblem.h>
#include <Teuchos_ParameterList.hpp>

namespace Signorini
{
  using namespace dealii;

  namespace LA
  {
    namespace
    {
      std::string
      amesos_name(const DirectLibrary library)
      {
        return library == DirectLibrary::MUMPS ? "Amesos_Mumps" : "Amesos_Klu";
      }
    } // namespace



    std::string
    name_of(const DirectLibrary library)
    {
      return library == DirectLibrary::MUMPS ? "MUMPS" :
             library == DirectLibrary::KLU   ? "KLU" :
                                               "SparseLU";
    }



    DirectSolver::DirectSolver(const DirectLibrary library)
      : library(library)
    {}



    DirectSolver::~DirectSolver() = default;



    bool
    DirectSolver::is_available(const DirectLibrary library)
    {
      return library == DirectLibrary::SparseLU || Amesos().Query(amesos_name(library));
    }



    // Symbolic and numeric factorisation; the matrix is referred to by the library.
    int
    DirectSolver::factorise(const SparseMatrix &matrix)
    {
      clear();
      if (library == DirectLibrary::SparseLU)
        {
          Assert(Utilities::MPI::n_mpi_processes(matrix.get_mpi_communicator()) == 1,
                 ExcInternalError());
          ordered = std::make_unique<OrderedLU>();
          return ordered->factorise(matrix) ? 0 : 1;
        }
      problem = std::make_unique<Epetra_LinearProblem>();
      problem->SetOperator(const_cast<Epetra_CrsMatrix *>(&matrix.trilinos_matrix()));
      solver.reset(Amesos().Create(amesos_name(library), *problem));
      AssertThrow(solver, ExcMessage("this Trilinos has no " + name_of(library)));
      Teuchos::ParameterList parameters;
      // Multipliers have zeros on the diagonal: their pivots are delayed, and MUMPS needs more
      // memory than it estimates (200 % more is allowed).
      parameters.sublist("mumps").set("ICNTL(14)", 200);
      solver->SetParameters(parameters);
      const int error = solver->SymbolicFactorization();
      return error == 0 ? solver->NumericFactorization() : error;
    }



    void
    DirectSolver::clear()
    {
      solver.reset();
      problem.reset();
      ordered.reset();
    }



    // Back substitution with the factors; x and the right-hand side are distributed as the rows.
    // Collective.
    void
    DirectSolver::solve(Vector &x, const Vector &right) const
    {
      if (ordered)
        return ordered->solve(x, right);
      Assert(solver, ExcNotInitialized());
      problem->SetLHS(&x.trilinos_vector());
      problem->SetRHS(const_cast<Epetra_MultiVector *>(&right.trilinos_vector()));
      const int error = solver->Solve();
      AssertThrow(error == 0, ExcTrilinosError(error));
    }
  } // namespace LA
} // namespace Signorini
