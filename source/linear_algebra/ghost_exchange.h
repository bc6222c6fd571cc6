// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/partitioner.h>

#include <cstdint>
#include <vector>

namespace Signorini
{
  namespace LA
  {
    /// Between the elements of a distributed vector that this rank owns, one after the other, and
    /// copies of those of other ranks that it needs, behind them. All but local_index() and dof()
    /// is collective.
    template <typename Number>
    class GhostExchange
    {
    public:
      GhostExchange(const dealii::IndexSet &owned,
                    const dealii::IndexSet &ghosts,
                    const MPI_Comm          comm)
        : partition(owned, ghosts, comm)
        , sent(partition.n_import_indices())
      {}

      std::size_t
      n_owned() const
      {
        return partition.locally_owned_size();
      }

      std::size_t
      n_ghosts() const
      {
        return partition.n_ghost_indices();
      }

      /// The local index of an element that this rank owns or has as a ghost.
      std::uint32_t
      local_index(const dealii::types::global_dof_index dof) const
      {
        return partition.global_to_local(dof);
      }

      dealii::types::global_dof_index
      dof(const std::uint32_t local_index) const
      {
        return partition.local_to_global(local_index);
      }

      void
      fetch(const Number *owned, Number *ghosts) const
      {
        std::vector<MPI_Request> requests;
        const auto               to = dealii::make_array_view(ghosts, ghosts + n_ghosts());
        partition.export_to_ghosted_array_start(0,
                                                dealii::ArrayView<const Number>(owned, n_owned()),
                                                dealii::make_array_view(sent),
                                                to,
                                                requests);
        partition.export_to_ghosted_array_finish(to, requests);
      }

      /// Add the values of ghosts to those of their owners; they are undefined afterwards.
      void
      add(Number *ghosts, Number *owned) const
      {
        send(dealii::VectorOperation::add, ghosts, owned);
      }

      /// Elements become the largest of their own values and those of ghosts, which are void then.
      void
      enlarge(Number *ghosts, Number *owned) const
      {
        send(dealii::VectorOperation::max, ghosts, owned);
      }

    private:
      void
      send(const dealii::VectorOperation::values how, Number *ghosts, Number *owned) const
      {
        std::vector<MPI_Request> requests;
        const auto               from = dealii::make_array_view(ghosts, ghosts + n_ghosts());
        partition.import_from_ghosted_array_start(
          how, 0, from, dealii::make_array_view(sent), requests);
        partition.import_from_ghosted_array_finish(
          how,
          dealii::ArrayView<const Number>(sent.data(), sent.size()),
          dealii::make_array_view(owned, owned + n_owned()),
          from,
          requests);
      }

      const dealii::Utilities::MPI::Partitioner partition;
      mutable std::vector<Number>               sent;
    };
  } // namespace LA
} // namespace Signorini
