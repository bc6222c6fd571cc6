// SPDX-License-Identifier: Apache-2.0
#include "solver/interface_solver.h"

#include "linear_algebra/row_view.h"
#include "linear_algebra/sparsity_pattern.h"
#include "linear_algebra/values.h"
#include "solver/linear_solver.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// A marker of degrees of freedom, from the rows of contact points of all ranks. Collective.
    /// @param mark called as mark(row, point, marks) for each row of this rank; sets marks of local
    /// columns to 1
    template <typename Mark>
    LA::Vector
    marked_by(const ContactSystem &system, const Mark &mark)
    {
      LA::Vector marker;
      marker.reinit(system.zero().block(0));
      if (system.gap_operator().empty())
        return marker;
      const GapOperator       &contact = system.gap_operator();
      const LA::ColumnExchange columns(contact.B_free);
      std::vector<double>      marks(columns.size(), 0.);
      for (unsigned int a = 0; a < contact.n_components(); ++a)
        {
          int row = 0;
          for (const auto i : contact.weight.locally_owned_elements())
            mark(LA::RowView(contact.free_rows(a), row++), i, marks);
        }
      // Columns may belong to other ranks, to which the marks are sent.
      columns.enlarge(marks.data(), marker);
      return marker;
    }

    /// Mark the columns of nonzero entries of a row.
    void
    mark_entries(const LA::RowView &row, std::vector<double> &marks)
    {
      for (int k = 0; k < row.size; ++k)
        if (row.values[k] != 0)
          marks[row.columns[k]] = 1;
    }

  } // namespace



  LA::Vector
  active_interface_dofs(const ContactSystem &system)
  {
    return marked_by(system, [&](const LA::RowView &row, const auto i, auto &marks) {
      if (system.is_active_point(i))
        mark_entries(row, marks);
    });
  }



  // In each row the components with at least a fifth of the largest entry of their node.
  LA::Vector
  dominant_interface_dofs(const ContactSystem &system, const unsigned int n_components)
  {
    // Smaller components of the gap's gradient at a node are omitted, relative to its largest one.
    constexpr double                     little = 0.2;
    std::vector<types::global_dof_index> nodes;
    if (!system.gap_operator().empty())
      nodes = LA::global_columns(system.gap_operator().B_free);
    for (auto &node : nodes)
      node /= n_components;
    std::map<types::global_dof_index, double> largest;
    return marked_by(system, [&](const LA::RowView &row, const auto i, auto &marks) {
      if (!system.is_active_point(i))
        return;
      largest.clear();
      for (int k = 0; k < row.size; ++k)
        {
          double &of_node = largest[nodes[row.columns[k]]];
          of_node         = std::max(of_node, std::abs(row.values[k]));
        }
      for (int k = 0; k < row.size; ++k)
        if (const double size = std::abs(row.values[k]);
            size > 0 && size >= little * largest[nodes[row.columns[k]]])
          marks[row.columns[k]] = 1;
    });
  }



  LA::Vector
  potential_interface_dofs(const ContactSystem &system)
  {
    return marked_by(system, [](const LA::RowView &row, const auto, auto &marks) {
      mark_entries(row, marks);
    });
  }



  /// Collects matrix entries in the numbering of the restricted system, in any order and with
  /// repeated positions.
  class InterfaceSolver::Entries
  {
  public:
    void
    add(const types::global_dof_index i, const types::global_dof_index j, const double value)
    {
      all.push_back({i, j, value});
    }

    /// Assemble the sum of the entries as a matrix, those of rows of other ranks included.
    /// Collective.
    void
    sum_up(const IndexSet &owned, const MPI_Comm comm, LA::SparseMatrix &matrix)
    {
      std::sort(all.begin(), all.end(), [](const Entry &a, const Entry &b) {
        return std::tie(a.row, a.column) < std::tie(b.row, b.column);
      });
      IndexSet            writable = owned;
      LA::SparsityPattern pattern;
      for_each_row([&](const auto row, const auto &, const auto &) {
        if (!owned.is_element(row))
          writable.add_index(row);
      });
      pattern.reinit(owned, owned, writable, comm, 0u);
      for_each_row([&](const auto row, const auto &columns, const auto &) {
        pattern.add_entries(row, columns.begin(), columns.end(), true);
      });
      pattern.compress();
      matrix.reinit(pattern);
      for_each_row([&](const auto row, const auto &columns, const auto &values) {
        matrix.add(row, columns, values);
      });
      matrix.compress(VectorOperation::add);
    }

  private:
    /// Call act(row, columns, values) for each row, with each column once. The entries are sorted.
    template <typename Action>
    void
    for_each_row(const Action &act) const
    {
      std::vector<types::global_dof_index> columns;
      std::vector<double>                  values;
      for (auto entry = all.begin(); entry != all.end();)
        {
          const auto row = entry->row;
          columns.clear();
          values.clear();
          for (; entry != all.end() && entry->row == row; ++entry)
            if (!columns.empty() && columns.back() == entry->column)
              values.back() += entry->value;
            else
              {
                columns.push_back(entry->column);
                values.push_back(entry->value);
              }
          act(row, columns, values);
        }
    }

    struct Entry
    {
      types::global_dof_index row, column;
      double                  value;
    };

    std::vector<Entry> all;
  };



  // Number the included unknowns contiguously over the ranks: on each rank first the marked degrees
  // of freedom, then the multipliers of its points, component by component. Collective.
  InterfaceSolver::InterfaceSolver(const ContactSystem    &system,
                                   const LA::Vector       &marker,
                                   const LA::DirectLibrary direct_library,
                                   const bool              with_geometric)
    : system(system)
    , K(system.stiffness().rows(marker))
    , columns_of_K(K)
    , x_of_K(columns_of_K.size())
    , library(direct_library)
    , with_geometric(with_geometric)
    , solver(direct_library)
  {
    const double *const marks = LA::values_of(marker);
    for (unsigned int i = 0; i < marker.locally_owned_size(); ++i)
      if (marks[i] != 0)
        dofs.emplace_back(i, 0);
    const unsigned int n_rows =
      system.is_saddle_point() ?
        system.n_multiplier_blocks() * system.gap_operator().weight.locally_owned_size() :
        0;
    const MPI_Comm comm = marker.get_mpi_communicator();
    owned               = LA::contiguous_partition(dofs.size() + n_rows, comm);
    number.reinit(marker);
    number     = -1.;
    auto index = owned.begin();
    for (auto &[dof, interface] : dofs)
      LA::values_of(number)[dof] = interface = *index++;
    if (n_rows > 0)
      first_row = *index;

    // The numbers of the columns of K and B, some of which other ranks own.
    number_in_K = columns_of_K.fetch(number);
    if (!system.gap_operator().empty())
      number_in_B = LA::ColumnExchange(system.gap_operator().B_free).fetch(number);
    left.reinit(owned, comm);
    right.reinit(owned, comm);
    contact_terms = system.zero();
  }



  // Entries of R A R^T: rows of K at the included degrees of freedom, contact terms, and the
  // geometric stiffness if it is wanted.
  void
  InterfaceSolver::collect(Entries &entries) const
  {
    for (const auto &[dof, interface] : dofs)
      {
        const LA::RowView row(K, dof);
        for (int k = 0; k < row.size; ++k)
          if (const double column = number_in_K[row.columns[k]]; column >= 0)
            entries.add(interface, column, row.values[k]);
      }
    if (system.gap_operator().empty())
      return;

    if (system.is_saddle_point())
      collect_multipliers(entries);
    else
      collect_contact_stiffness(entries);
    if (with_geometric && system.uses_geometric_stiffness())
      collect_geometric(entries);
  }



  // -G of the geometric stiffness, for the entries whose row and column are both included.
  void
  InterfaceSolver::collect_geometric(Entries &entries) const
  {
    system.gap_operator().for_each_geometric_entry(
      number, [&](const double row, const double column, const double value) {
        entries.add(row, column, -value);
      });
  }



  // B^T D B (or the unsymmetric form with normal stresses) is available as a matrix over the local
  // columns, see ContactSystem.
  void
  InterfaceSolver::collect_contact_stiffness(Entries &entries) const
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



  // The blocks of (4.5): -B^T A, -C B and -I. Diagonal entries of I are stored even if they are
  // zero, for the factorisation.
  void
  InterfaceSolver::collect_multipliers(Entries &entries) const
  {
    const GapOperator &contact  = system.gap_operator();
    const int          n        = system.n_multiplier_blocks();
    const int          n_points = contact.weight.locally_owned_size();
    for (int i = 0; i < n_points; ++i)
      for (int a = 0; a < n; ++a)
        {
          const LA::RowView row(contact.free_rows(a), i);
          const double      coupling = LA::values_of(system.coupling())[i];
          const auto        own      = first_row + n * i;
          for (int k = 0; k < row.size; ++k)
            if (const double column = number_in_B[row.columns[k]]; column >= 0)
              {
                if (coupling != 0)
                  entries.add(column, own + a, -coupling * row.values[k]);
                for (int b = 0; b < n; ++b)
                  if (const double C = LA::values_of(system.constraint()[b][a])[i]; C != 0)
                    entries.add(own + b, column, -C * row.values[k]);
              }
          for (int b = 0; b < n; ++b)
            if (const double I = LA::values_of(system.identity()[a][b])[i]; I != 0 || a == b)
              entries.add(own + a, own + b, -I);
        }
  }



  // Assemble and factorise the restricted matrix; costs that of a surface problem. Collective.
  void
  InterfaceSolver::update()
  {
    Entries entries;
    collect(entries);
    solver.clear();
    entries.sum_up(owned, system.stiffness().communicator(), matrix);

    if (const int error = solver.factorise(matrix); error != 0)
      throw SolverFailure(LA::name_of(library) + " cannot factorise " +
                          std::to_string(owned.size()) +
                          " unknowns of the contact interface (error " + std::to_string(error) +
                          "); try another Solver/Direct solver, or a penalty method");
  }



  // Call act(block, local point) for the multipliers of this rank, in the order of their numbers.
  template <typename Action>
  void
  InterfaceSolver::for_each_multiplier(const Action &act) const
  {
    if (!system.is_saddle_point())
      return;
    const unsigned int n_points = system.gap_operator().weight.locally_owned_size();
    for (unsigned int i = 0; i < n_points; ++i)
      for (unsigned int a = 0; a < system.n_multiplier_blocks(); ++a)
        act(1 + a, i);
  }



  // x += R^T (R A R^T)^-1 R r (doc/theory, (7.5)), for a residual r that is known. Collective.
  void
  InterfaceSolver::add_correction(LA::BlockVector &x, const LA::BlockVector &r) const
  {
    double *at = LA::values_of(right);
    for (const auto &entry : dofs)
      *at++ = LA::values_of(r.block(0))[entry.first];
    for_each_multiplier([&](const unsigned int block, const unsigned int i) {
      *at++ = LA::values_of(r.block(block))[i];
    });
    add_solution(x);
  }



  // Right-hand side R (r - A x): only the rows of included unknowns are evaluated, the contact
  // terms on the surface and the marked rows of K.
  void
  InterfaceSolver::correct(LA::BlockVector &x, const LA::BlockVector &r) const
  {
    system.contact_terms(contact_terms, x);
    if (with_geometric && system.uses_geometric_stiffness())
      system.gap_operator().subtract_geometric(contact_terms.block(0), x.block(0));
    columns_of_K.fetch(x.block(0), x_of_K.data());
    double *at = LA::values_of(right);
    for (const auto &entry : dofs)
      {
        const unsigned int dof = entry.first;
        const LA::RowView  row(K, dof);
        double             force = LA::values_of(contact_terms.block(0))[dof];
        for (int k = 0; k < row.size; ++k)
          force += row.values[k] * x_of_K[row.columns[k]];
        *at++ = LA::values_of(r.block(0))[dof] - force;
      }
    for_each_multiplier([&](const unsigned int block, const unsigned int i) {
      *at++ = LA::values_of(r.block(block))[i] - LA::values_of(contact_terms.block(block))[i];
    });
    add_solution(x);
  }



  // Solve for the restricted correction and add it to the unknowns.
  void
  InterfaceSolver::add_solution(LA::BlockVector &x) const
  {
    solver.solve(left, right);

    const double *from = LA::values_of(left);
    for (const auto &entry : dofs)
      LA::values_of(x.block(0))[entry.first] += *from++;
    for_each_multiplier([&](const unsigned int block, const unsigned int i) {
      LA::values_of(x.block(block))[i] += *from++;
    });
  }
} // namespace Signorini
