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
  /// The checkpoints in the directory of a run: folders checkpoint-NNNN with a file `head` for all
  /// ranks, and one file for each rank. The last two are kept. A folder gets its final name when
  /// everything in it is on the disk, so that there are no incomplete checkpoints.
  class Checkpoints
  {
  public:
    /// @param directory of the run
    /// @param comm the ranks
    Checkpoints(const std::string &directory, MPI_Comm comm);

    /// The contents of a checkpoint.
    struct Content
    {
      /// Name of the folder.
      std::string            name;
      nlohmann::ordered_json head;
      /// Contents of the files that this rank has to process.
      std::vector<std::string> parts;
    };

    /// @return the newest checkpoint that is not damaged; none if there are no checkpoints. Throws
    /// SceneError if all are damaged. Collective.
    /// @param out receives messages about damaged ones
    std::optional<Content>
    newest(dealii::ConditionalOStream &out);

    /// Write a checkpoint; the last of the former ones is kept. Collective.
    /// @param head contents of `head`, the same on all ranks
    /// @param part contents of the file of this rank
    /// @return false if the disk cannot store it; then nothing has changed
    bool
    write(const nlohmann::ordered_json &head, const std::string &part);

    /// @return the size [bytes] of the last checkpoint, over all ranks.
    double
    bytes() const
    {
      return my_bytes;
    }
    /// @return the time [s] that the last write() took.
    double
    seconds() const
    {
      return my_seconds;
    }

    /// True if there are none. Collective.
    bool
    empty() const
    {
      return names().empty();
    }

    /// Remove all checkpoints, at the end of a run. Collective.
    void
    remove();

  private:
    Content
    read(const std::string &name) const;
    /// @return the names of all checkpoints, the oldest first. Collective.
    std::vector<std::string>
    names() const;
    void
    publish(const std::string &name);

    const std::string  directory;
    const MPI_Comm     comm;
    const unsigned int rank, n_ranks;
    /// Names of the complete ones that are kept.
    std::vector<std::string> kept;
    double                   my_bytes = 0, my_seconds = 0;
  };
} // namespace Signorini
