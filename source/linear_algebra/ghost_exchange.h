// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/partitioner.h>

#include <cstdint>
#include <vector>

namespace Signorini
{
  namespace LA
  {
    /// Exchange between the owned elements of a distributed vector, in an array, and copies of
    /// elements of other ranks ("ghosts"), in another one, which usually follows the first. All
    /// functions but n_owned(), n_ghosts(), local_index() and dof() are collective.
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

      /// The number of elements that this rank owns.
      std::size_t
      n_owned() const
      {
        return partition.locally_owned_size();
      }

      /// The number of copies of elements of other ranks.
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

      /// The inverse of local_index().
      dealii::types::global_dof_index
      dof(const std::uint32_t local_index) const
      {
        return partition.local_to_global(local_index);
      }

      /// Set the ghosts to the values of their owners. @param owned n_owned() elements; @param
      /// ghosts n_ghosts() elements
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

      /// Raise the owned elements to the largest of their own values and those of their ghosts,
      /// which are undefined afterwards.
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
