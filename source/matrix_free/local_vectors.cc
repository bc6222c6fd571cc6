// SPDX-License-Identifier: Apache-2.0
#include "matrix_free/local_vectors.h"

#include "linear_algebra/own_range.h"

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The degrees of freedom of the nodes of several lists, each once, sorted.
    std::vector<types::global_dof_index>
    dofs_of(const std::vector<const std::vector<std::uint32_t> *> &lists, const IndexSet &owned)
    {
      // Nodes of this rank are marked in an array, which is cheaper than sorting; those of other
      // ranks are few and are sorted. The names of nodes are their first degrees of freedom, so
      // that the other two components follow.
      const LA::OwnRange                   own(owned);
      std::vector<bool>                    is_there(own.size(), false);
      std::vector<types::global_dof_index> nodes, result;
      for (const auto *list : lists)
        for (const types::global_dof_index node : *list)
          if (own.has(node))
            is_there[own.local_index(node)] = true;
          else
            nodes.push_back(node);
      for (std::size_t i = 0; i < is_there.size(); ++i)
        if (is_there[i])
          nodes.push_back(own.dof(i));
      std::sort(nodes.begin(), nodes.end());
      nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
      for (const auto node : nodes)
        for (unsigned int c = 0; c < 3; ++c)
          result.push_back(node + c);
      return result;
    }

    /// The degrees of freedom of other ranks that are needed: those of the cells, and those that
    /// constraints of these refer to.
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
              // A constrained value is computed on each rank that has it, from the values that it
              // depends on, so that these must be known there as well.
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
    // Constrained degrees of freedom of the cells, with their constraints as compressed rows over
    // local indices.
    const std::vector<types::global_dof_index> touched = dofs_of(nodes, owned);
    exchange = std::make_unique<LA::GhostExchange<Number>>(owned,
                                                           ghosts_of(owned, touched, constraints),
                                                           comm);
    // Lines are sorted by local index, so that vectors are accessed in the order of memory.
    std::vector<std::pair<std::uint32_t, types::global_dof_index>> lines;
    for (const auto dof : touched)
      if (constraints.is_constrained(dof))
        lines.emplace_back(local_index(dof), dof);
    std::sort(lines.begin(), lines.end());
    for (const auto &[at, dof] : lines)
      {
        constrained.push_back(at);
        if (owned.is_element(dof))
          my_owned_constrained.push_back(at);
        first.push_back(elements.size());
        for (const auto &entry : *constraints.get_constraint_entries(dof))
          {
            elements.push_back(local_index(entry.first));
            weights.push_back(entry.second);
          }
      }
    first.push_back(elements.size());
    // One element more, since kernels may read beyond the last one.
    of_u.resize(exchange->n_owned() + exchange->n_ghosts() + 1);
    of_f.resize(of_u.size());
  }



  // x = C u: owned values, ghosts, then constrained values as combinations of the others.
  // Collective.
  template <typename Number>
  const Number *
  LocalVectors<Number>::resolve(const Number *u) const
  {
    Number *const x = of_u.data();
    std::copy_n(u, exchange->n_owned(), x);
    exchange->fetch(x, x + exchange->n_owned());
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
    std::fill(of_f.begin(), of_f.end(), Number(0));
    return of_f.data();
  }



  // Add C^T f: forces on constrained degrees of freedom go to those on which they depend; then
  // ghosts to their owners. Collective.
  template <typename Number>
  Number *
  LocalVectors<Number>::condense() const
  {
    Number *const f = of_f.data();
    for (std::size_t k = 0; k < constrained.size(); ++k)
      {
        for (std::uint32_t e = first[k]; e < first[k + 1]; ++e)
          f[elements[e]] += weights[e] * f[constrained[k]];
        // Products are zero at constrained degrees of freedom; the operator adds its own terms
        // there.
        f[constrained[k]] = 0;
      }
    return sum();
  }



  // The diagonal of C^T K C, as far as it comes from the diagonal of K. Products of two different
  // entries of K would contribute as well where one degree of freedom determines several of a cell,
  // but are not known without a matrix.
  template <typename Number>
  Number *
  LocalVectors<Number>::condense_diagonal() const
  {
    for (std::size_t k = 0; k < constrained.size(); ++k)
      for (std::uint32_t e = first[k]; e < first[k + 1]; ++e)
        of_f[elements[e]] += weights[e] * weights[e] * of_f[constrained[k]];
    return sum();
  }



  // Contributions to ghosts are added on their owners. Collective.
  template <typename Number>
  Number *
  LocalVectors<Number>::sum() const
  {
    exchange->add(of_f.data() + exchange->n_owned(), of_f.data());
    return of_f.data();
  }



  // The owner of a value takes the largest of its own and those of the ghosts. Collective.
  template <typename Number>
  Number *
  LocalVectors<Number>::largest() const
  {
    exchange->enlarge(of_f.data() + exchange->n_owned(), of_f.data());
    return of_f.data();
  }



  template class LocalVectors<float>;
  template class LocalVectors<double>;
} // namespace Signorini
