#pragma once

#include <deal.II/base/mpi.h>
#include <deal.II/grid/cell_id.h>

#include <cstdint>
#include <map>
#include <vector>

namespace Signorini
{
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

  /// What any rank knows of the cells that this rank asks for: all tell it to the rank that the
  /// name of the cell says, and that one is asked.
  template <typename T>
  std::map<dealii::CellId, T>
  look_up(const std::map<dealii::CellId, T> &known,
          const std::vector<dealii::CellId> &wanted,
          const MPI_Comm                     comm)
  {
    using Entry        = std::pair<dealii::CellId, T>;
    const auto n_ranks = dealii::Utilities::MPI::n_mpi_processes(comm);
    std::map<unsigned int, std::vector<Entry>> told;
    for (const auto &entry : known)
      told[hash_of(entry.first) % n_ranks].emplace_back(entry);
    std::map<dealii::CellId, T> directory;
    for (const auto &[rank, entries] : dealii::Utilities::MPI::some_to_some(comm, told))
      directory.insert(entries.begin(), entries.end());

    std::map<unsigned int, std::vector<dealii::CellId>> asked;
    for (const dealii::CellId &id : wanted)
      asked[hash_of(id) % n_ranks].push_back(id);
    std::map<unsigned int, std::vector<Entry>> answers;
    for (const auto &[rank, ids] : dealii::Utilities::MPI::some_to_some(comm, asked))
      for (const dealii::CellId &id : ids)
        if (const auto found = directory.find(id); found != directory.end())
          answers[rank].emplace_back(*found);
    std::map<dealii::CellId, T> result;
    for (const auto &[rank, entries] : dealii::Utilities::MPI::some_to_some(comm, answers))
      result.insert(entries.begin(), entries.end());
    return result;
  }
} // namespace Signorini
