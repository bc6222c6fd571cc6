// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/conditional_ostream.h>
#include <deal.II/base/mpi.h>

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

namespace Signorini
{
  /// The checkpoints in the directory of a run: folders checkpoint-NNNN with a file `head`, which
  /// all ranks know, and a file a rank. The last two are kept. A folder gets its name when all in
  /// it is on the disk, so that there are no halves of checkpoints.
  class Checkpoints
  {
  public:
    Checkpoints(const std::string &directory, MPI_Comm comm);

    struct Content
    {
      std::string              name; ///< of the folder
      nlohmann::ordered_json   head;
      std::vector<std::string> parts; ///< those that this rank has to take care of
    };

    /// The newest one that is whole; others are told on `out`. None if there are none. Throws
    /// SceneError if there are only damaged ones. Collective.
    std::optional<Content>
    newest(dealii::ConditionalOStream &out);

    /// Beside the former ones, of which the last stays. False if the disk does not take it: then
    /// all is as it was. Collective.
    /// @param head the same on all ranks
    bool
    write(const nlohmann::ordered_json &head, const std::string &part);

    /// What the last write() cost: bytes of all ranks, and seconds.
    double
    bytes() const
    {
      return my_bytes;
    }
    double
    seconds() const
    {
      return my_seconds;
    }

    /// Remove the checkpoints of a run that needs them no more. Collective.
    void
    remove();

  private:
    Content
    read(const std::string &name) const;
    /// Names of all, the oldest first, from the first rank.
    std::vector<std::string>
    names() const;
    void
    publish(const std::string &name);

    const std::string        directory;
    const MPI_Comm           comm;
    const unsigned int       rank, n_ranks;
    std::vector<std::string> kept; ///< whole ones
    double                   my_bytes = 0, my_seconds = 0;
  };
} // namespace Signorini
