// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/mpi.h>
#include <deal.II/grid/cell_id.h>

#include <cstdint>
#include <map>
#include <vector>

namespace Signorini
{
  /// @return a hash of the id of a cell (FNV-1a), the same on all ranks.
  /// @param id of a cell
  inline std::uint64_t
  hash_of(const dealii::CellId &id)
  {
    std::uint64_t hash = 14695981039346656037ull; // FNV-1a
    const auto    add  = [&](const std::uint64_t part) { hash = (hash ^ part) * 1099511628211ull; };
    add(id.get_coarse_cell_id());
    for (const auto child : id.get_child_indices())
      add(child + 1);
    return hash ^ (hash >> 29);
  }

  /// @return whether a cell has a parent, i.e. is not a coarse cell.
  /// @param id of the cell
  inline bool
  has_parent(const dealii::CellId &id)
  {
    return id.get_child_indices().size() > 0;
  }

  /// @return the number of a cell among the children of its parent.
  /// @param id of a cell that has a parent
  inline unsigned int
  number_of_child(const dealii::CellId &id)
  {
    return *(id.get_child_indices().end() - 1);
  }

  /// @return the id of the parent.
  /// @param id of a cell that has a parent
  inline dealii::CellId
  parent_of(const dealii::CellId &id)
  {
    const auto children = id.get_child_indices();
    return {id.get_coarse_cell_id(),
            static_cast<unsigned int>(children.size() - 1),
            &*children.begin()};
  }

  /// @return the id of a child, whether or not it exists.
  /// @param id of the parent
  /// @param child its number
  inline dealii::CellId
  child_of(const dealii::CellId &id, const unsigned int child)
  {
    const auto                view = id.get_child_indices();
    std::vector<std::uint8_t> children(view.begin(), view.end());
    children.push_back(child);
    return {id.get_coarse_cell_id(), static_cast<unsigned int>(children.size()), children.data()};
  }

  /// Look up values by cell ids (or other keys) that any rank may have. All ranks send their
  /// entries to the rank that hash_of() assigns to the key, which answers requests: a distributed
  /// directory with sparse communication. Collective.
  /// @param known entries of this rank
  /// @param wanted keys that this rank looks up
  /// @param comm the ranks
  /// @return the entries of those keys that any rank has
  template <typename Name, typename T>
  std::map<Name, T>
  gather_values(const std::map<Name, T> &known,
                const std::vector<Name> &wanted,
                const MPI_Comm           comm)
  {
    using Entry        = std::pair<Name, T>;
    const auto n_ranks = dealii::Utilities::MPI::n_mpi_processes(comm);
    std::map<unsigned int, std::vector<Entry>> entries_by_rank;
    for (const auto &entry : known)
      entries_by_rank[hash_of(entry.first) % n_ranks].emplace_back(entry);
    std::map<Name, T> directory;
    for (const auto &[rank, entries] : dealii::Utilities::MPI::some_to_some(comm, entries_by_rank))
      directory.insert(entries.begin(), entries.end());

    std::map<unsigned int, std::vector<Name>> asked;
    for (const Name &name : wanted)
      asked[hash_of(name) % n_ranks].push_back(name);
    std::map<unsigned int, std::vector<Entry>> answers;
    for (const auto &[rank, names] : dealii::Utilities::MPI::some_to_some(comm, asked))
      for (const Name &name : names)
        if (const auto found = directory.find(name); found != directory.end())
          answers[rank].emplace_back(*found);
    std::map<Name, T> result;
    for (const auto &[rank, entries] : dealii::Utilities::MPI::some_to_some(comm, answers))
      result.insert(entries.begin(), entries.end());
    return result;
  }
} // namespace Signorini
