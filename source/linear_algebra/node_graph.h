// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "linear_algebra/ghost_exchange.h"
#include "linear_algebra/types.h"

#include <functional>
#include <vector>

namespace Signorini
{
  namespace LA
  {
    /// Sets of nodes by their global numbers, one after the other: those of cells.
    struct NodeSets
    {
      std::vector<std::size_t>                     first{0}; ///< of each set, and the end
      std::vector<dealii::types::global_dof_index> nodes;
    };

    /// For each member of some sets, the sets that have it: those of member i from first[i] on.
    struct SetsOfMembers
    {
      /// @param first member of each set, and the end
      /// @param members of the sets, one after the other, below n_members
      SetsOfMembers(const std::vector<std::size_t>   &first,
                    const std::vector<std::uint32_t> &members,
                    std::uint32_t                     n_members);

      std::vector<std::size_t>   first;
      std::vector<std::uint32_t> sets; ///< ascending for each member
    };

    /// The nodes of a stiffness, each with n_components successive unknowns, and the pairs of them
    /// that it couples. Local nodes are those of this rank, then those of other ranks that they are
    /// coupled to.
    class NodeGraph
    {
    public:
      using Index = dealii::types::global_dof_index;

      /// The graph of a matrix. Couplings of value zero, which eliminated constraints leave, are
      /// none. Collective.
      /// @param n_components unknowns of a node, two or three
      /// @param n_kept number of nodes at the end that all levels have, those of rigid bodies
      NodeGraph(const SparseMatrix &K, unsigned int n_components, Index n_kept);

      /// The graph of cells. Collective.
      /// @param cells of this rank; all nodes of each are coupled
      /// @param is_free whether an owned unknown is not prescribed
      /// @param owned unknowns of this rank
      NodeGraph(const NodeSets                   &cells,
                const std::function<bool(Index)> &is_free,
                const dealii::IndexSet           &owned,
                unsigned int                      n_components,
                Index                             n_kept,
                MPI_Comm                          comm);

      /// The number of nodes of this rank.
      std::uint32_t
      n_owned() const
      {
        return exchange.n_owned();
      }

      /// The number of local nodes.
      std::uint32_t
      size() const
      {
        return exchange.n_owned() + exchange.n_ghosts();
      }

      /// The local nodes to which a local node is coupled by entries or cells of this rank, itself
      /// excluded.
      const std::uint32_t *
      begin(const std::uint32_t node) const
      {
        return neighbours.data() + first[node];
      }

      const std::uint32_t *
      end(const std::uint32_t node) const
      {
        return neighbours.data() + first[node + 1];
      }

      /// True if a component of a node is an unknown of the system; supports leave none.
      bool
      is_free(const std::uint32_t node, const unsigned int component) const
      {
        return free[node] >> component & 1;
      }

      /// True if any component is.
      bool
      is_free(const std::uint32_t node) const
      {
        return free[node] != 0;
      }

      /// True if all levels have a node.
      bool
      is_kept(const std::uint32_t node) const
      {
        return global(node) >= first_kept;
      }

      /// The global number of a local node.
      Index
      global(const std::uint32_t node) const
      {
        return exchange.dof(node);
      }

      /// The inverse of global().
      std::uint32_t
      local(const Index node) const
      {
        return exchange.local_index(node);
      }

      /// Extend values of the nodes of this rank by those of the others. Collective.
      void
      fetch(std::vector<double> &values) const;

      /// Raise values of all nodes to the largest of the copies of each on all ranks. Collective.
      void
      enlarge(std::vector<double> &values) const;

      const unsigned int n_components;
      const MPI_Comm     comm;

    private:
      /// Set which unknowns are free, from those of this rank. Collective.
      void
      set_free(std::vector<double> &&bits);

      GhostExchange<double>      exchange;
      const Index                first_kept;
      std::vector<std::size_t>   first;
      std::vector<std::uint32_t> neighbours;
      std::vector<unsigned char> free; ///< bit c: component c
    };
  } // namespace LA
} // namespace Signorini
