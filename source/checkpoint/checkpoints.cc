// SPDX-License-Identifier: Apache-2.0
#include "checkpoint/checkpoints.h"

#include "checkpoint/sealed_file.h"
#include "output/directory.h"
#include <signorini/parameters/raw.h>

#include <deal.II/base/timer.h>

#include <algorithm>
#include <filesystem>
#include <regex>

namespace Signorini
{
  using namespace dealii;
  namespace fs = std::filesystem;

  namespace
  {
    const std::string beginning = "checkpoint-";

    /// @return the path of the file of a rank.
    std::string
    part_of(const std::string &folder, const unsigned int rank)
    {
      return folder + "/part-" + std::to_string(rank);
    }

    /// @return the number of a checkpoint, from the name of its folder.
    unsigned int
    number_of(const std::string &name)
    {
      return std::stoul(name.substr(beginning.size()));
    }
  } // namespace



  Checkpoints::Checkpoints(const std::string &directory, const MPI_Comm comm)
    : directory(directory)
    , comm(comm)
    , rank(Utilities::MPI::this_mpi_process(comm))
    , n_ranks(Utilities::MPI::n_mpi_processes(comm))
  {}



  std::vector<std::string>
  Checkpoints::names() const
  {
    std::vector<std::string> result;
    const std::regex         pattern(beginning + "[0-9]{4,9}");
    std::error_code          error;
    if (rank == 0)
      for (const auto &entry : fs::directory_iterator(directory, error))
        if (const std::string name = entry.path().filename();
            entry.is_directory() && std::regex_match(name, pattern))
          result.push_back(name);
    std::sort(result.begin(), result.end(), [](const auto &a, const auto &b) {
      return number_of(a) < number_of(b);
    });
    return Utilities::MPI::broadcast(comm, result);
  }



  // Parts are distributed over the present ranks, whose number may differ from that of the run that
  // wrote them.
  Checkpoints::Content
  Checkpoints::read(const std::string &name) const
  {
    const std::string folder = directory + "/" + name;
    Content     content{name, nlohmann::ordered_json::parse(read_sealed(folder + "/head")), {}};
    const auto &sums = content.head.at("parts");
    for (unsigned int part = rank; part < sums.size(); part += n_ranks)
      {
        content.parts.push_back(read_sealed(part_of(folder, part)));
        if (sums[part] != checksum(content.parts.back()))
          throw Damaged(part_of(folder, part) + " belongs to a different checkpoint");
      }
    return content;
  }



  // From the newest one backwards; damage on any rank makes all ranks try the one before.
  std::optional<Checkpoints::Content>
  Checkpoints::newest(ConditionalOStream &out)
  {
    const std::vector<std::string> all = names();
    std::string                    damages;
    for (auto name = all.rbegin(); name != all.rend(); ++name)
      {
        Content     content;
        std::string damage;
        try
          {
            content = read(*name);
          }
        catch (const std::exception &error)
          {
            damage = error.what();
          }
        // The message of the first rank that has found damage.
        for (const std::string &one : Utilities::MPI::all_gather(comm, damage))
          if (!one.empty())
            {
              damage = one;
              break;
            }
        if (damage.empty())
          {
            // The one before was not read; it is kept in case that this one gets damaged.
            kept.clear();
            if (std::next(name) != all.rend())
              kept.push_back(*std::next(name));
            kept.push_back(*name);
            return content;
          }
        out << "  WARNING: " << damage << std::endl;
        damages += (damages.empty() ? "" : "; ") + damage;
      }
    if (!all.empty())
      throw SceneError("--restart " + directory +
                       ": no checkpoint in that directory is complete: " + damages +
                       "; solve the scene from the start");
    return {};
  }



  // Everything is written into a temporary folder, which is renamed when it is complete on the
  // disk. After each step all ranks know whether all have succeeded. Then checkpoints other than
  // the last two are removed.
  bool
  Checkpoints::write(const nlohmann::ordered_json &head, const std::string &part)
  {
    Timer             clock;
    const auto        all = names();
    const std::string name =
                        beginning +
                        Utilities::int_to_string(all.empty() ? 1 : number_of(all.back()) + 1, 4),
                      unfinished = directory + "/" + name + ".tmp";
    // Executes an action on some ranks, and returns on all ranks whether it has succeeded
    // everywhere.
    const auto succeeds = [&](const bool takes_part, const auto &action) {
      bool done = true;
      if (takes_part)
        try
          {
            action();
          }
        catch (const std::exception &)
          {
            done = false;
          }
      return Utilities::MPI::min(int(done), comm) == 1;
    };
    nlohmann::ordered_json with_parts = head;
    with_parts["parts"]               = Utilities::MPI::all_gather(comm, checksum(part));
    const std::string text            = with_parts.dump();

    const bool done = succeeds(rank == 0,
                               [&] {
                                 fs::remove_all(unfinished);
                                 fs::create_directory(unfinished);
                               }) &&
                      succeeds(true, [&] { write_sealed(part_of(unfinished, rank), part); }) &&
                      succeeds(rank == 0, [&] {
                        write_sealed(unfinished + "/head", text);
                        publish(name);
                      });
    std::error_code error;
    if (!done && rank == 0)
      fs::remove_all(unfinished, error);
    if (done)
      kept.push_back(name);
    if (kept.size() > 2)
      kept.erase(kept.begin(), kept.end() - 2);
    if (done && rank == 0)
      for (const std::string &old : all)
        if (std::count(kept.begin(), kept.end(), old) == 0)
          fs::remove_all(directory + "/" + old, error);
    my_bytes   = Utilities::MPI::sum(double(part.size()), comm) + text.size();
    my_seconds = Utilities::MPI::max(clock.wall_time(), comm);
    return done;
  }



  // The order of synchronisation makes sure that a folder with its final name is complete even
  // after a crash of the machine.
  void
  Checkpoints::publish(const std::string &name)
  {
    const std::string path = directory + "/" + name;
    sync_folder(path + ".tmp");
    fs::rename(path + ".tmp", path);
    sync_folder(directory);
  }



  void
  Checkpoints::remove()
  {
    std::error_code error;
    for (const std::string &name : names())
      if (rank == 0)
        fs::remove_all(directory + "/" + name, error);
    kept.clear();
    MPI_Barrier(comm);
  }
} // namespace Signorini
