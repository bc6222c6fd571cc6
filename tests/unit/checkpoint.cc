// SPDX-License-Identifier: Apache-2.0
// Checkpoints on the disk: what is damaged is seen, and the one before is taken.

#include "checkpoint/checkpoints.h"
#include "checkpoint/origin.h"
#include "checkpoint/sealed_file.h"
#include <signorini/parameters/raw.h>

#include <doctest/doctest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

using namespace Signorini;
using namespace dealii;

namespace
{
  namespace fs = std::filesystem;

  unsigned int
  this_rank()
  {
    return Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  }

  /// The same on all ranks, empty, and gone after the test.
  struct Folder
  {
    Folder()
      : path(fs::temp_directory_path() /
             ("signorini-checkpoint-" +
              std::to_string(
                Utilities::MPI::broadcast(MPI_COMM_WORLD, static_cast<unsigned int>(getpid())))))
    {
      if (this_rank() == 0)
        {
          fs::remove_all(path);
          fs::create_directories(path);
        }
      MPI_Barrier(MPI_COMM_WORLD);
    }

    ~Folder()
    {
      MPI_Barrier(MPI_COMM_WORLD);
      if (this_rank() == 0)
        fs::remove_all(path);
    }

    std::set<std::string>
    names() const
    {
      MPI_Barrier(MPI_COMM_WORLD);
      std::set<std::string> result;
      for (const auto &entry : fs::directory_iterator(path))
        result.insert(entry.path().filename());
      MPI_Barrier(MPI_COMM_WORLD);
      return result;
    }

    const fs::path path;
  };

  std::string
  read(const fs::path &path)
  {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  void
  write(const fs::path &path, const std::string &text)
  {
    std::ofstream(path, std::ios::binary) << text;
  }

  /// As a disk does it. On the first rank; the others wait.
  void
  damage(const fs::path &path)
  {
    if (this_rank() == 0)
      {
        std::string text = read(path);
        text[text.size() / 2] ^= 4;
        write(path, text);
      }
    MPI_Barrier(MPI_COMM_WORLD);
  }

  bool
  is_damaged(const fs::path &path)
  {
    try
      {
        read_sealed(path);
      }
    catch (const Damaged &)
      {
        return true;
      }
    return false;
  }

  std::string
  part_of(const unsigned int rank, const int number)
  {
    return "part " + std::to_string(rank) + " of " + std::to_string(number) +
           std::string(rank, '\0');
  }

  bool
  write_number(Checkpoints &checkpoints, const int number)
  {
    return checkpoints.write({{"number", number}}, part_of(this_rank(), number));
  }

  /// Of the newest whole checkpoint; 0 if there is none, -1 if all are damaged. `warnings` of the
  /// first rank.
  int
  newest_number(const Folder &folder, std::string &warnings)
  {
    Checkpoints        checkpoints(folder.path, MPI_COMM_WORLD);
    std::ostringstream text;
    ConditionalOStream out(text, true);
    try
      {
        const auto found = checkpoints.newest(out);
        warnings         = text.str();
        if (!found)
          return 0;
        const int number = found->head.at("number");
        CHECK(found->parts == std::vector<std::string>{part_of(this_rank(), number)});
        return number;
      }
    catch (const SceneError &)
      {
        return -1;
      }
  }
} // namespace



TEST_CASE("a sealed file with any change is not read")
{
  const Folder      folder;
  const fs::path    path    = folder.path / ("file-" + std::to_string(this_rank()));
  const std::string content = std::string("some\0content\n", 13) + std::string(100, '\7');
  write_sealed(path, content);
  CHECK(read_sealed(path) == content);
  const std::string whole = read(path);
  for (std::size_t i = 0; i < whole.size(); ++i)
    {
      std::string changed = whole;
      changed[i] ^= 1;
      write(path, changed);
      CHECK_MESSAGE(is_damaged(path), "byte " << i);
      write(path, whole.substr(0, i));
      CHECK_MESSAGE(is_damaged(path), "only " << i << " bytes");
    }
  write(path, whole + "x");
  CHECK(is_damaged(path));
  write_sealed(path, "");
  CHECK(read_sealed(path).empty());
  CHECK(is_damaged(folder.path / "no-such-file"));
}



TEST_CASE("the last two checkpoints are kept, and a damaged one is passed over")
{
  const Folder folder;
  std::string  warnings;
  CHECK(newest_number(folder, warnings) == 0);
  {
    Checkpoints checkpoints(folder.path, MPI_COMM_WORLD);
    for (int number = 1; number <= 3; ++number)
      CHECK(write_number(checkpoints, number));
    CHECK(checkpoints.bytes() > 0);
  }
  CHECK(folder.names() == std::set<std::string>{"checkpoint-0002", "checkpoint-0003"});
  CHECK(newest_number(folder, warnings) == 3);
  CHECK(warnings.empty());

  // What a process leaves that is killed while it writes is neither read nor in the way.
  if (this_rank() == 0)
    {
      fs::create_directory(folder.path / "checkpoint-0004.tmp");
      write(folder.path / "checkpoint-0004.tmp" / "part-0", "half of");
    }
  CHECK(newest_number(folder, warnings) == 3);

  const unsigned int last = Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) - 1;
  damage(folder.path / "checkpoint-0003" / ("part-" + std::to_string(last)));
  CHECK(newest_number(folder, warnings) == 2);
  CHECK(warnings.find("checkpoint-0003/part-" + std::to_string(last)) != std::string::npos);

  // A run that goes on keeps the whole one, not the damaged one.
  {
    Checkpoints        checkpoints(folder.path, MPI_COMM_WORLD);
    std::ostringstream text;
    ConditionalOStream out(text, true);
    CHECK(checkpoints.newest(out)->head.at("number") == 2);
    CHECK(write_number(checkpoints, 4));
  }
  CHECK(folder.names() == std::set<std::string>{"checkpoint-0002", "checkpoint-0004"});
  CHECK(newest_number(folder, warnings) == 4);

  damage(folder.path / "checkpoint-0004" / "head");
  damage(folder.path / "checkpoint-0002" / "head");
  CHECK(newest_number(folder, warnings) == -1);

  Checkpoints(folder.path, MPI_COMM_WORLD).remove();
  CHECK(folder.names().empty());
}



TEST_CASE("a checkpoint that the disk does not take leaves the former one")
{
  const Folder folder;
  std::string  warnings;
  Checkpoints  checkpoints(folder.path, MPI_COMM_WORLD);
  CHECK(write_number(checkpoints, 1));
  // No file may get so large, on the last rank only.
  const auto    handler = std::signal(SIGXFSZ, SIG_IGN);
  struct rlimit former, limit;
  getrlimit(RLIMIT_FSIZE, &former);
  limit                   = former;
  limit.rlim_cur          = 1000;
  const unsigned int last = Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) - 1;
  if (this_rank() == last)
    setrlimit(RLIMIT_FSIZE, &limit);
  const bool done = checkpoints.write({{"number", 2}}, std::string(2000, 'x'));
  setrlimit(RLIMIT_FSIZE, &former);
  std::signal(SIGXFSZ, handler);
  CHECK(!done);
  CHECK(folder.names() == std::set<std::string>{"checkpoint-0001"});
  CHECK(newest_number(folder, warnings) == 1);
}



TEST_CASE("a run knows its scene and its files again")
{
  const Folder      folder;
  const std::string directory = folder.path / std::to_string(this_rank());
  fs::create_directories(directory);
  const std::string mesh = directory + "/mesh.msh";
  write(mesh, "some nodes\n");
  const auto refusal = [&] {
    try
      {
        read_origin(directory);
      }
    catch (const SceneError &error)
      {
        return std::string(error.what());
      }
    return std::string();
  };
  CHECK(refusal().find("has no file restart.scene") != std::string::npos);
  write_origin(directory,
               origin_of("scene", "subsection Bodies\n  set File = " + mesh + "\nend\n"));
  CHECK(refusal().empty());
  CHECK(read_origin(directory).name == "scene");
  write(mesh, "other nodes\n");
  CHECK(refusal().find("has changed since the run began") != std::string::npos);
  fs::remove(mesh);
  CHECK(refusal().find("is gone") != std::string::npos);

  CHECK_NOTHROW(check_change("Newton/Tolerance=1e-9", false));
  CHECK_NOTHROW(check_change("Load steps/Cut-backs=3", false));
  CHECK_NOTHROW(check_change("Output/VTU=no", false));
  for (const char *word : {"Load steps/Number=3",
                           "Bodies/block/Young's modulus=1",
                           "Output/Directory=elsewhere",
                           "Contact method/Method=penalty",
                           "Dimension=2"})
    CHECK_THROWS_AS(check_change(word, false), SceneError);
  for (const char *word :
       {"Load steps/Number=3", "Loads/a/Traction=t; 0", "Contact pairs/a/End time=3"})
    CHECK_NOTHROW(check_change(word, true));
  for (const char *word :
       {"Contact pairs/a/Friction=1", "Obstacles/a/Displacement=t; 0", "Mesh/Degree=2"})
    CHECK_THROWS_AS(check_change(word, true), SceneError);
}
