// SPDX-License-Identifier: Apache-2.0
#include "linear_algebra/node_graph.h"

#include "linear_algebra/columns.h"
#include "linear_algebra/own_range.h"
#include "linear_algebra/row_view.h"

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  namespace LA
  {
    namespace
    {
      using Index = types::global_dof_index;

      /// The nodes whose unknowns are owned.
      IndexSet
      owned_nodes(const IndexSet &owned, const unsigned int n_components)
      {
        IndexSet       result(owned.size() / n_components);
        const OwnRange range(owned);
        if (range.size() > 0)
          result.add_range(range.dof(0) / n_components,
                           (range.dof(0) + range.size()) / n_components);
        return result;
      }

      /// The nodes of a list that are not owned.
      IndexSet
      others(std::vector<Index> nodes, const IndexSet &owned)
      {
        nodes.erase(std::remove_if(nodes.begin(),
                                   nodes.end(),
                                   [&](const Index node) { return owned.is_element(node); }),
                    nodes.end());
        std::sort(nodes.begin(), nodes.end());
        nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
        IndexSet result(owned.size());
        result.add_indices(nodes.begin(), nodes.end());
        return result;
      }

      /// The nodes of the local columns of a matrix.
      std::vector<Index>
      nodes_of_columns(const SparseMatrix &K, const unsigned int n_components)
      {
        std::vector<Index> result = global_columns(K);
        for (Index &column : result)
          column /= n_components;
        return result;
      }
    } // namespace



    // The sets of each member are counted first.
    SetsOfMembers::SetsOfMembers(const std::vector<std::size_t>   &first_of_set,
                                 const std::vector<std::uint32_t> &members,
                                 const std::uint32_t               n_members)
      : first(n_members + 1, 0)
      , sets(members.size())
    {
      for (const std::uint32_t member : members)
        ++first[member + 1];
      for (std::uint32_t i = 0; i < n_members; ++i)
        first[i + 1] += first[i];
      std::vector<std::size_t> next(first.begin(), first.end() - 1);
      for (std::uint32_t set = 0; set + 1 < first_of_set.size(); ++set)
        for (std::size_t i = first_of_set[set]; i < first_of_set[set + 1]; ++i)
          sets[next[members[i]]++] = set;
    }



    // A component without couplings has no stiffness of its neighbours: it is supported.
    NodeGraph::NodeGraph(const SparseMatrix &K, const unsigned int n_components, const Index n_kept)
      : n_components(n_components)
      , comm(K.get_mpi_communicator())
      , exchange(owned_nodes(K.locally_owned_range_indices(), n_components),
                 others(nodes_of_columns(K, n_components),
                        owned_nodes(K.locally_owned_range_indices(), n_components)),
                 comm)
      , first_kept(K.m() / n_components - n_kept)
    {
      const std::vector<Index>   columns = global_columns(K);
      std::vector<std::uint32_t> node_of;
      for (const Index column : columns)
        node_of.push_back(local(column / n_components));
      std::vector<double>        bits(n_owned(), 0.);
      std::vector<std::uint32_t> seen_from(size(), size());
      first.push_back(0);
      for (std::uint32_t node = 0; node < n_owned(); ++node)
        {
          unsigned int of_node = 0;
          seen_from[node]      = node;
          for (unsigned int c = 0; c < n_components; ++c)
            {
              const RowView row(K, node * n_components + c);
              for (int k = 0; k < row.size; ++k)
                {
                  const std::uint32_t other = node_of[row.columns[k]];
                  if (row.values[k] == 0 ||
                      (other == node && columns[row.columns[k]] % n_components == c))
                    continue;
                  of_node |= 1u << c;
                  if (seen_from[other] != node)
                    neighbours.push_back(other);
                  seen_from[other] = node;
                }
            }
          bits[node] = of_node;
          first.push_back(neighbours.size());
        }
      first.resize(size() + 1, neighbours.size());
      set_free(std::move(bits));
    }



    // Neighbours are the nodes of the same cells; of nodes of other ranks those in cells of this
    // one.
    NodeGraph::NodeGraph(const NodeSets                   &cells,
                         const std::function<bool(Index)> &is_free,
                         const IndexSet                   &owned,
                         const unsigned int                n_components,
                         const Index                       n_kept,
                         const MPI_Comm                    comm)
      : n_components(n_components)
      , comm(comm)
      , exchange(owned_nodes(owned, n_components),
                 others(cells.nodes, owned_nodes(owned, n_components)),
                 comm)
      , first_kept(owned.size() / n_components - n_kept)
    {
      std::vector<std::uint32_t> nodes;
      for (const Index node : cells.nodes)
        nodes.push_back(local(node));
      const SetsOfMembers        cells_of(cells.first, nodes, size());
      std::vector<std::uint32_t> seen_from(size(), size());
      first.push_back(0);
      for (std::uint32_t node = 0; node < size(); ++node)
        {
          seen_from[node] = node;
          for (std::size_t k = cells_of.first[node]; k < cells_of.first[node + 1]; ++k)
            for (std::size_t i = cells.first[cells_of.sets[k]];
                 i < cells.first[cells_of.sets[k] + 1];
                 ++i)
              if (seen_from[nodes[i]] != node)
                {
                  seen_from[nodes[i]] = node;
                  neighbours.push_back(nodes[i]);
                }
          first.push_back(neighbours.size());
        }
      std::vector<double> bits(n_owned(), 0.);
      for (std::uint32_t node = 0; node < n_owned(); ++node)
        {
          unsigned int of_node = 0;
          for (unsigned int c = 0; c < n_components; ++c)
            if (is_free(global(node) * n_components + c))
              of_node |= 1u << c;
          bits[node] = of_node;
        }
      set_free(std::move(bits));
    }



    // Nodes of rigid bodies have no couplings, but are unknowns.
    void
    NodeGraph::set_free(std::vector<double> &&bits)
    {
      fetch(bits);
      free.assign(bits.begin(), bits.end());
      for (std::uint32_t node = 0; node < size(); ++node)
        if (is_kept(node))
          free[node] = (1u << n_components) - 1;
    }



    void
    NodeGraph::fetch(std::vector<double> &values) const
    {
      values.resize(size());
      exchange.fetch(values.data(), values.data() + exchange.n_owned());
    }



    void
    NodeGraph::enlarge(std::vector<double> &values) const
    {
      exchange.enlarge(values.data() + exchange.n_owned(), values.data());
      fetch(values);
    }
  } // namespace LA
} // namespace Signorini
