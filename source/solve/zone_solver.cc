#include <signorini/linear_algebra/row_view.h>
#include <signorini/linear_algebra/sparsity_pattern.h>
#include <signorini/linear_algebra/values.h>
#include <signorini/solve/linear_solver.h>
#include <signorini/solve/zone_solver.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Marks columns. @param mark of a row, its number and the marks of columns on this rank
    template <typename Mark>
    LA::Vector
    marked_by(const ContactSystem &system, const Mark &mark)
    {
      LA::Vector marker;
      marker.reinit(system.zero().block(0));
      if (system.gap_operator().empty())
        return marker;
      const LA::SparseMatrix  &B = system.gap_operator().B_free;
      const LA::ColumnExchange columns(B);
      std::vector<double>      marks(columns.size(), 0.);
      int                      row = 0;
      for (const auto i : system.gap_operator().weight.locally_owned_elements())
        mark(LA::RowView(B, row++), i, marks);
      // Columns may belong to other ranks: tell them.
      columns.enlarge(marks.data(), marker);
      return marker;
    }

    void
    mark_entries(const LA::RowView &row, std::vector<double> &marks)
    {
      for (int k = 0; k < row.size; ++k)
        if (row.values[k] != 0)
          marks[row.columns[k]] = 1;
    }

    bool
    presses(const ContactSystem &system, const types::global_dof_index i)
    {
      return system.spring()(i) != 0 || system.coupling()(i) != 0;
    }
  } // namespace



  LA::Vector
  contact_zone(const ContactSystem &system)
  {
    return marked_by(system, [&](const LA::RowView &row, const auto i, auto &marks) {
      if (presses(system, i))
        mark_entries(row, marks);
    });
  }



  LA::Vector
  contact_core(const ContactSystem &system, const unsigned int n_components)
  {
    constexpr double                     little = 0.2; // of the node's largest entry
    std::vector<types::global_dof_index> nodes;
    if (!system.gap_operator().empty())
      nodes = LA::global_columns(system.gap_operator().B_free);
    for (auto &node : nodes)
      node /= n_components;
    std::map<types::global_dof_index, double> largest;
    return marked_by(system, [&](const LA::RowView &row, const auto i, auto &marks) {
      if (!presses(system, i))
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
  contact_reach(const ContactSystem &system)
  {
    return marked_by(system, [](const LA::RowView &row, const auto, auto &marks) {
      mark_entries(row, marks);
    });
  }



  /// Matrix entries in zone numbering.
  class ZoneSolver::Entries
  {
  public:
    void
    add(const types::global_dof_index i, const types::global_dof_index j, const double value)
    {
      all.push_back({i, j, value});
    }

    /// A matrix of their sum. Collective.
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
    /// Calls act(row, columns, values), each column once.
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



  ZoneSolver::ZoneSolver(const ContactSystem    &system,
                         const LA::Vector       &marker,
                         const LA::DirectLibrary direct_library,
                         const bool              turns)
    : system(system)
    , K(system.stiffness().rows(marker))
    , columns_of_K(K)
    , x_of_K(columns_of_K.size())
    , library(direct_library)
    , turns(turns)
    , solver(direct_library)
  {
    const double *const marks = LA::values_of(marker);
    for (unsigned int i = 0; i < marker.locally_owned_size(); ++i)
      if (marks[i] != 0)
        dofs.emplace_back(i, 0);
    const unsigned int n_rows =
      system.is_saddle_point() ? system.gap_operator().origin.pair.size() : 0;
    const MPI_Comm comm = marker.get_mpi_communicator();
    owned               = LA::contiguous_partition(dofs.size() + n_rows, comm);
    number.reinit(marker);
    number     = -1.;
    auto index = owned.begin();
    for (auto &[dof, zone] : dofs)
      LA::values_of(number)[dof] = zone = *index++;
    if (n_rows > 0)
      first_row = *index;

    number_in_K = columns_of_K.fetch(number);
    if (!system.gap_operator().empty())
      number_in_B = LA::ColumnExchange(system.gap_operator().B_free).fetch(number);
    left.reinit(owned, comm);
    right.reinit(owned, comm);
    contact_terms = system.zero();
  }



  void
  ZoneSolver::collect(Entries &entries) const
  {
    for (const auto &[dof, zone] : dofs)
      {
        const LA::RowView row(K, dof);
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
    if (turns && system.turns_forces())
      collect_geometric(entries);
  }



  void
  ZoneSolver::collect_geometric(Entries &entries) const
  {
    system.gap_operator().for_each_geometric_entry(
      number, [&](const double row, const double column, const double value) {
        entries.add(row, column, -value);
      });
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
        const LA::RowView row(system.gap_operator().B_free, i);
        const double      coupling = LA::values_of(system.coupling())[i];
        for (int k = 0; k < row.size; ++k)
          if (const double column = number_in_B[row.columns[k]]; column >= 0 && coupling != 0)
            {
              entries.add(column, first_row + i, -coupling * row.values[k]);
              entries.add(first_row + i, column, -coupling * row.values[k]);
            }
        entries.add(first_row + i, first_row + i, -LA::values_of(system.identity())[i]);
      }
  }



  void
  ZoneSolver::update()
  {
    Entries entries;
    collect(entries);
    solver.clear();
    entries.sum_up(owned, system.stiffness().communicator(), matrix);

    if (const int error = solver.factorise(matrix); error != 0)
      throw SolverFailure(LA::name_of(library) + " cannot factorise " +
                          std::to_string(owned.size()) + " unknowns of the contact zone (error " +
                          std::to_string(error) +
                          "); try another Solver/Direct solver, or a penalty method");
  }



  void
  ZoneSolver::add_correction(LA::BlockVector &x, const LA::BlockVector &r) const
  {
    double *at = LA::values_of(right);
    for (const auto &entry : dofs)
      *at++ = LA::values_of(r.block(0))[entry.first];
    if (system.is_saddle_point())
      std::copy_n(LA::values_of(r.block(1)), r.block(1).locally_owned_size(), at);
    add_solution(x);
  }



  void
  ZoneSolver::correct(LA::BlockVector &x, const LA::BlockVector &r) const
  {
    system.contact_terms(contact_terms, x);
    if (turns && system.turns_forces())
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
    if (system.is_saddle_point())
      for (unsigned int i = 0; i < r.block(1).locally_owned_size(); ++i)
        *at++ = LA::values_of(r.block(1))[i] - LA::values_of(contact_terms.block(1))[i];
    add_solution(x);
  }



  void
  ZoneSolver::add_solution(LA::BlockVector &x) const
  {
    solver.solve(left, right);

    const double *from = LA::values_of(left);
    for (const auto &entry : dofs)
      LA::values_of(x.block(0))[entry.first] += *from++;
    if (system.is_saddle_point())
      for (unsigned int i = 0; i < x.block(1).locally_owned_size(); ++i)
        LA::values_of(x.block(1))[i] += *from++;
  }
} // namespace Signorini
