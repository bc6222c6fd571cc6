#include <signorini/linear_algebra/values.h>
#include <signorini/matrix_free/local_vectors.h>

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The degrees of freedom of nodes, each once.
    std::vector<types::global_dof_index>
    dofs_of(const std::vector<const std::vector<std::uint32_t> *> &lists, const IndexSet &owned)
    {
      const types::global_dof_index        start = owned.is_empty() ? 0 : owned.nth_index_in_set(0);
      std::vector<bool>                    is_there(owned.n_elements(), false);
      std::vector<types::global_dof_index> nodes, result;
      for (const auto *list : lists)
        for (const types::global_dof_index node : *list)
          if (node < start || node - start >= is_there.size())
            nodes.push_back(node); // of others
          else
            is_there[node - start] = true;
      for (std::size_t i = 0; i < is_there.size(); ++i)
        if (is_there[i])
          nodes.push_back(start + i);
      std::sort(nodes.begin(), nodes.end());
      nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
      for (const auto node : nodes)
        for (unsigned int c = 0; c < 3; ++c)
          result.push_back(node + c);
      return result;
    }

    /// Of other ranks: those of the cells, and those that these hang on.
    IndexSet
    ghosts_of(const IndexSet                             &owned,
              const std::vector<types::global_dof_index> &touched,
              const AffineConstraints<double>            &constraints)
    {
      std::vector<types::global_dof_index> ghosts;
      const auto                           note = [&](const types::global_dof_index dof) {
        if (!owned.is_element(dof))
          ghosts.push_back(dof);
      };
      for (const auto dof : touched)
        {
          note(dof);
          if (const auto *line = constraints.get_constraint_entries(dof))
            for (const auto &entry : *line)
              note(entry.first);
        }
      std::sort(ghosts.begin(), ghosts.end());
      ghosts.erase(std::unique(ghosts.begin(), ghosts.end()), ghosts.end());
      IndexSet result(owned.size());
      result.add_indices(ghosts.begin(), ghosts.end());
      return result;
    }
  } // namespace



  template <typename Number>
  LocalVectors<Number>::LocalVectors(const IndexSet                                        &owned,
                                     const std::vector<const std::vector<std::uint32_t> *> &nodes,
                                     const AffineConstraints<double> &constraints,
                                     const MPI_Comm                   comm)
  {
    const std::vector<types::global_dof_index> touched = dofs_of(nodes, owned);
    partition =
      std::make_shared<Utilities::MPI::Partitioner>(owned,
                                                    ghosts_of(owned, touched, constraints),
                                                    comm);
    std::vector<std::pair<std::uint32_t, types::global_dof_index>> lines;
    for (const auto dof : touched)
      if (constraints.is_constrained(dof))
        lines.emplace_back(place(dof), dof);
    std::sort(lines.begin(), lines.end());
    for (const auto &[at, dof] : lines)
      {
        constrained.push_back(at);
        if (owned.is_element(dof))
          my_owned_constrained.push_back(at);
        first.push_back(elements.size());
        for (const auto &entry : *constraints.get_constraint_entries(dof))
          {
            elements.push_back(place(entry.first));
            weights.push_back(entry.second);
          }
      }
    first.push_back(elements.size());
    of_u.reinit(partition);
    of_f.reinit(partition);
  }



  template <typename Number>
  const Number *
  LocalVectors<Number>::resolve(const LA::Vector &u) const
  {
    std::copy_n(LA::values_of(u), u.locally_owned_size(), of_u.begin());
    of_u.update_ghost_values();
    Number *const x = of_u.begin();
    for (std::size_t k = 0; k < constrained.size(); ++k)
      {
        Number value = 0;
        for (std::uint32_t e = first[k]; e < first[k + 1]; ++e)
          value += weights[e] * x[elements[e]];
        x[constrained[k]] = value;
      }
    return x;
  }



  template <typename Number>
  Number *
  LocalVectors<Number>::zero() const
  {
    std::fill_n(of_f.begin(), partition->locally_owned_size() + partition->n_ghost_indices(), 0);
    return of_f.begin();
  }



  template <typename Number>
  void
  LocalVectors<Number>::condense(LA::Vector &v) const
  {
    Number *const f = of_f.begin();
    for (std::size_t k = 0; k < constrained.size(); ++k)
      {
        for (std::uint32_t e = first[k]; e < first[k + 1]; ++e)
          f[elements[e]] += weights[e] * f[constrained[k]];
        f[constrained[k]] = 0;
      }
    sum(v);
  }



  template <typename Number>
  void
  LocalVectors<Number>::sum(LA::Vector &v) const
  {
    of_f.compress(VectorOperation::add);
    copy_owned(v);
  }



  template <typename Number>
  void
  LocalVectors<Number>::largest(LA::Vector &v) const
  {
    of_f.compress(VectorOperation::max);
    copy_owned(v);
  }



  template <typename Number>
  void
  LocalVectors<Number>::copy_owned(LA::Vector &v) const
  {
    std::copy_n(of_f.begin(), v.locally_owned_size(), LA::values_of(v));
  }



  template <typename Number>
  std::size_t
  LocalVectors<Number>::memory() const
  {
    return 4 * (constrained.size() + first.size() + elements.size()) +
           sizeof(Number) * (weights.size() + 2 * of_u.locally_owned_size());
  }



  template class LocalVectors<float>;
  template class LocalVectors<double>;
} // namespace Signorini
