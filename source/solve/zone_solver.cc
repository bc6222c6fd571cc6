#include <signorini/row_view.h>
#include <signorini/solve/linear_solver.h>
#include <signorini/solve/zone_solver.h>

#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include <Amesos.h>
#include <Amesos_BaseSolver.h>
#include <Epetra_CrsMatrix.h>
#include <Epetra_Import.h>
#include <Epetra_LinearProblem.h>
#include <Epetra_Vector.h>
#include <Teuchos_ParameterList.hpp>

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// A vector on the degrees of freedom, as the local columns of a matrix see it.
    std::vector<double>
    on_columns(const LA::SparseMatrix &matrix, const LA::Vector &v)
    {
      const Epetra_CrsMatrix &A = matrix.trilinos_matrix();
      Epetra_Vector           columns(A.ColMap());
      // A matrix has no importer where all columns are local; the one made here then only copies.
      const int error =
        A.Importer() ?
          columns.Import(v.trilinos_vector(), *A.Importer(), Insert) :
          columns.Import(v.trilinos_vector(), Epetra_Import(A.ColMap(), A.DomainMap()), Insert);
      AssertThrow(error == 0, ExcTrilinosError(error));
      return std::vector<double>(columns.Values(), columns.Values() + columns.MyLength());
    }

    /// The owned elements in a row: access by global index costs ten times more, and is collective
    /// now and then.
    double *
    values_of(LA::Vector &v)
    {
      return v.trilinos_vector()[0];
    }

    const double *
    values_of(const LA::Vector &v)
    {
      return v.trilinos_vector()[0];
    }
  } // namespace



  LA::Vector
  contact_zone(const ContactSystem &system)
  {
    LA::Vector marker;
    marker.reinit(system.zero().block(0));
    if (system.gap_operator().empty())
      return marker;
    const Epetra_CrsMatrix &B = system.gap_operator().B_free.trilinos_matrix();
    Epetra_Vector           columns(B.ColMap());
    int                     row = 0;
    for (const auto i : system.gap_operator().weight.locally_owned_elements())
      {
        const RowView view(B, row++);
        if (system.spring()(i) != 0 || system.coupling()(i) != 0)
          for (int k = 0; k < view.size; ++k)
            if (view.values[k] != 0)
              columns[view.columns[k]] = 1;
      }
    // Columns may belong to other ranks: tell them.
    Epetra_MultiVector &owned = marker.trilinos_vector();
    const int error = owned.Export(columns, Epetra_Import(B.ColMap(), B.DomainMap()), AbsMax);
    AssertThrow(error == 0, ExcTrilinosError(error));
    return marker;
  }



  /// Matrix entries in zone numbering.
  struct ZoneSolver::Entries
  {
    std::vector<types::global_dof_index> rows, columns;
    std::vector<double>                  values;

    void
    add(const types::global_dof_index i, const types::global_dof_index j, const double value)
    {
      rows.push_back(i);
      columns.push_back(j);
      values.push_back(value);
    }
  };



  ZoneSolver::ZoneSolver(const ContactSystem &system,
                         const LA::Vector    &marker,
                         const std::string   &direct_solver)
    : system(system)
    , K(system.stiffness().rows(marker))
    , direct_solver("Amesos_" +
                    (direct_solver == "MUMPS" ? std::string("Mumps") : std::string("Klu")))
  {
    const double *const marks = values_of(marker);
    for (unsigned int i = 0; i < marker.locally_owned_size(); ++i)
      if (marks[i] != 0)
        dofs.emplace_back(i, 0);
    const unsigned int n_rows =
      system.is_saddle_point() ? system.gap_operator().origin.pair.size() : 0;
    const MPI_Comm comm = marker.get_mpi_communicator();
    owned               = LA::contiguous_partition(dofs.size() + n_rows, comm);
    writable            = owned;

    LA::Vector number;
    number.reinit(marker);
    number     = -1.;
    auto index = owned.begin();
    for (auto &[dof, zone] : dofs)
      values_of(number)[dof] = zone = *index++;
    if (n_rows > 0)
      first_row = *index;

    number_in_K = on_columns(K, number);
    if (!system.gap_operator().empty())
      number_in_B = on_columns(system.gap_operator().B_free, number);
    for (const double zone : number_in_B)
      if (zone >= 0)
        writable.add_index(static_cast<types::global_dof_index>(zone));
    left.reinit(owned, comm);
    right.reinit(owned, comm);
    contact_terms = system.zero();
  }



  ZoneSolver::~ZoneSolver() = default;



  void
  ZoneSolver::collect(Entries &entries) const
  {
    for (const auto &[dof, zone] : dofs)
      {
        const RowView row(K, dof);
        for (int k = 0; k < row.size; ++k)
          if (const double column = number_in_K[row.columns[k]]; column >= 0)
            entries.add(zone, column, row.values[k]);
      }
    if (system.gap_operator().empty())
      return;

    if (system.is_saddle_point())
      collect_multipliers(entries);
    else
      collect_springs(entries);
  }



  void
  ZoneSolver::collect_springs(Entries &entries) const
  {
    if (system.surface_stiffness().empty())
      return; // no points on this rank
    for (const auto &entry : system.surface_stiffness())
      {
        const double row = number_in_B[entry.row()], column = number_in_B[entry.column()];
        if (row >= 0 && column >= 0 && entry.value() != 0)
          entries.add(row, column, entry.value());
      }
  }



  void
  ZoneSolver::collect_multipliers(Entries &entries) const
  {
    const int n_rows = system.gap_operator().weight.locally_owned_size();
    for (int i = 0; i < n_rows; ++i)
      {
        const RowView row(system.gap_operator().B_free, i);
        const double  coupling = values_of(system.coupling())[i];
        for (int k = 0; k < row.size; ++k)
          if (const double column = number_in_B[row.columns[k]]; column >= 0 && coupling != 0)
            {
              entries.add(column, first_row + i, -coupling * row.values[k]);
              entries.add(first_row + i, column, -coupling * row.values[k]);
            }
        entries.add(first_row + i, first_row + i, -values_of(system.identity())[i]);
      }
  }



  void
  ZoneSolver::update()
  {
    Entries entries;
    collect(entries);
    TrilinosWrappers::SparsityPattern pattern(
      owned, owned, writable, system.stiffness().communicator(), 0u);
    for (std::size_t i = 0; i < entries.values.size(); ++i)
      pattern.add(entries.rows[i], entries.columns[i]);
    pattern.compress();
    solver.reset();
    matrix.reinit(pattern);
    for (std::size_t i = 0; i < entries.values.size(); ++i)
      matrix.add(entries.rows[i], entries.columns[i], entries.values[i]);
    matrix.compress(VectorOperation::add);

    problem = std::make_unique<Epetra_LinearProblem>();
    problem->SetOperator(const_cast<Epetra_CrsMatrix *>(&matrix.trilinos_matrix()));
    solver.reset(Amesos().Create(direct_solver, *problem));
    Teuchos::ParameterList parameters;
    // Multipliers have zeros on the diagonal: their pivots are delayed, and MUMPS needs more memory
    // than it reckons with (in percent).
    parameters.sublist("mumps").set("ICNTL(14)", 200);
    solver->SetParameters(parameters);
    int error = solver->SymbolicFactorization();
    if (error == 0)
      error = solver->NumericFactorization();
    if (error != 0)
      throw SolverFailure(direct_solver + " cannot factorise " + std::to_string(owned.size()) +
                          " unknowns of the contact zone (error " + std::to_string(error) +
                          "); try another Solver/Direct solver, or a penalty method");
  }



  void
  ZoneSolver::add_correction(LA::BlockVector &x, const LA::BlockVector &r) const
  {
    double *at = values_of(right);
    for (const auto &entry : dofs)
      *at++ = values_of(r.block(0))[entry.first];
    if (system.is_saddle_point())
      std::copy_n(values_of(r.block(1)), r.block(1).locally_owned_size(), at);
    add_solution(x);
  }



  void
  ZoneSolver::correct(LA::BlockVector &x, const LA::BlockVector &r) const
  {
    system.contact_terms(contact_terms, x);
    const std::vector<double> x_K = on_columns(K, x.block(0));
    double                   *at  = values_of(right);
    for (const auto &entry : dofs)
      {
        const unsigned int dof = entry.first;
        const RowView      row(K, dof);
        double             force = values_of(contact_terms.block(0))[dof];
        for (int k = 0; k < row.size; ++k)
          force += row.values[k] * x_K[row.columns[k]];
        *at++ = values_of(r.block(0))[dof] - force;
      }
    if (system.is_saddle_point())
      for (unsigned int i = 0; i < r.block(1).locally_owned_size(); ++i)
        *at++ = values_of(r.block(1))[i] - values_of(contact_terms.block(1))[i];
    add_solution(x);
  }



  void
  ZoneSolver::add_solution(LA::BlockVector &x) const
  {
    problem->SetLHS(&left.trilinos_vector());
    problem->SetRHS(&right.trilinos_vector());
    const int error = solver->Solve();
    AssertThrow(error == 0, ExcTrilinosError(error));

    const double *from = values_of(left);
    for (const auto &entry : dofs)
      values_of(x.block(0))[entry.first] += *from++;
    if (system.is_saddle_point())
      for (unsigned int i = 0; i < x.block(1).locally_owned_size(); ++i)
        values_of(x.block(1))[i] += *from++;
  }
} // namespace Signorini
