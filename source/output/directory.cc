// SPDX-License-Identifier: Apache-2.0
#include "output/directory.h"

#include <signorini/parameters/raw.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    namespace fs = std::filesystem;

    /// Files of a run, described by regular expressions of folder and name, and by the beginning of
    /// their contents, because other programs may use the same names.
    struct Kind
    {
      const char *folder, *name, *beginning;
      /// Whether a run writes a file of this name, so that a file of other origin is an error.
      bool needed;
    };

    constexpr Kind kinds[] = {
      {"", "results\\.json(\\.part)?", "^\\s*\\{\\s*\"(program|scene)\"", true},
      {"", "scene\\.prm", "^# Written by Signorini", true},
      {"", "(solution|contact)\\.pvd", "deal\\.II|Signorini", true},
      {"", "(solution|contact|failed)_[0-9]{4,}\\.pvtu", "deal\\.II|Signorini", true},
      {"", "(solution|contact|failed)_[0-9]{4,}\\.[0-9]+\\.vtu", "deal\\.II|Signorini", true},
      {"", "restart\\.scene(\\.part)?", "^Signorini checkpoint", true},
      {"checkpoint-[0-9]{4,}(\\.tmp)?", "head|part-[0-9]+", "^Signorini checkpoint", false},
      {"",
       "((bodies|pressure|history|friction|probes|accuracy)\\.png|film\\.gif|report\\.html)",
       "Signorini",
       false},
      {"film", "[0-9]{4,}\\.png", "Signorini", false},
      {"profiles", ".*\\.csv", "^x,y,z,pressure,gap,status", false},
      {"profiles/step-[0-9]{4,}", ".*\\.csv", "^x,y,z,pressure,gap,status", false}};

    /// @return the first 1000 bytes of a file.
    std::string
    beginning_of(const fs::path &file)
    {
      std::string   text(1000, ' ');
      std::ifstream in(file, std::ios::binary);
      in.read(&text[0], text.size());
      text.resize(in.gcount());
      return text;
    }

    /// @return whether a file is empty or begins as files of this kind do.
    bool
    holds(const fs::path &file, const Kind &kind)
    {
      const std::string text = beginning_of(file);
      return text.empty() || std::regex_search(text, std::regex(kind.beginning));
    }

    /// @return the existing subfolders of the directory that match a pattern; the folder itself if
    /// that is no pattern.
    std::vector<fs::path>
    folders(const fs::path &directory, const std::string &pattern)
    {
      if (pattern.find('[') == std::string::npos)
        return {directory / pattern};
      std::vector<fs::path> result;
      const fs::path        parent = directory / fs::path(pattern).parent_path();
      const std::regex      name(fs::path(pattern).filename().string());
      std::error_code       error;
      for (const auto &entry : fs::directory_iterator(parent, error))
        if (entry.is_directory() && std::regex_match(entry.path().filename().string(), name))
          result.push_back(entry.path());
      return result;
    }

    /// @return the files that an earlier run has left. Throws SceneError for a file of other origin
    /// that would have to be replaced.
    std::vector<fs::path>
    stale_files(const fs::path &directory)
    {
      std::vector<fs::path> result;
      // Earlier versions wrote scenes without a mark: they are recognised by the results beside
      // them.
      const bool has_results =
        fs::exists(directory / "results.json") && holds(directory / "results.json", kinds[0]);
      for (const Kind &kind : kinds)
        for (const fs::path &folder : folders(directory, kind.folder))
          {
            const std::regex name(kind.name);
            std::error_code  error;
            for (const auto &entry : fs::directory_iterator(folder, error))
              if (std::regex_match(entry.path().filename().string(), name))
                {
                  const bool is_ours = holds(entry.path(), kind) ||
                                       (has_results && entry.path().filename() == "scene.prm");
                  if (entry.is_regular_file() && is_ours)
                    result.push_back(entry.path());
                  else if (kind.needed)
                    throw SceneError(
                      "Output/Directory = " + directory.string() + ": the file '" +
                      entry.path().filename().string() +
                      "' in that directory was not written by this program and would "
                      "be overwritten; move it, or choose another directory");
                }
          }
      return result;
    }

    /// Remove subfolders that are empty.
    void
    remove_empty_folders(const fs::path &directory)
    {
      std::error_code not_empty;
      for (const Kind &kind : kinds)
        if (std::string(kind.folder).find('[') != std::string::npos)
          for (const fs::path &folder : folders(directory, kind.folder))
            fs::remove(folder, not_empty);
    }

    /// Remove the files of an earlier run.
    void
    remove_stale_files(const fs::path &directory)
    {
      for (const fs::path &file : stale_files(directory))
        fs::remove(file);
      remove_empty_folders(directory);
    }

    /// @return the load step to which a file belongs, by its name or that of its folder; 0 for
    /// other files.
    unsigned int
    step_of(const fs::path &file)
    {
      const std::string folder = file.parent_path().filename(), name = file.filename();
      std::smatch       found;
      if (std::regex_match(folder, found, std::regex("step-([0-9]{4,9})")) ||
          std::regex_search(name,
                            found,
                            std::regex("^(?:solution|contact|failed)_([0-9]{4,9})\\.")))
        return std::stoul(found[1]);
      return 0;
    }

    /// Create a directory with its parents. Throws SceneError.
    void
    create(const fs::path &directory)
    {
      std::error_code error;
      fs::create_directories(directory, error);
      if (error)
        throw SceneError("Output/Directory: the directory '" + directory.string() +
                         "' cannot be created: " + error.message() + "; choose another one");
    }



    // The lock ------------------------------------------------------------------------------------

    /// @return the name of this machine.
    std::string
    host_name()
    {
      char name[256] = "";
      gethostname(name, sizeof(name) - 1);
      return name;
    }

    /// The process that has locked a directory, as the lock file describes it.
    struct Owner
    {
      pid_t       process = 0;
      std::string host;

      /// @return a text for messages.
      std::string
      text() const
      {
        return process > 0 ? "process " + std::to_string(process) + " on " + host :
                             "unknown process";
      }
    };

    /// @return the owner according to a lock file; process 0 if it is empty.
    Owner
    owner_of(const std::string &file)
    {
      Owner         owner;
      std::ifstream in(file);
      in >> owner.process >> owner.host;
      return owner;
    }

    /// Throw SceneError: another run uses the directory.
    [[noreturn]] void
    reject_locked(const std::string &directory, const std::string &file, const Owner &owner)
    {
      throw SceneError("Output/Directory = " + directory + ": another run uses it (" +
                       owner.text() +
                       "); choose another directory, or wait until that run has ended" +
                       (owner.host == host_name() ? "" : ", or remove " + file + " if it is"));
    }

    /// @return whether an open file is still the one of that name: its owner may have removed it
    /// between our opening and locking it.
    bool
    is_there(const int descriptor, const std::string &file)
    {
      struct stat mine, now;
      return fstat(descriptor, &mine) == 0 && stat(file.c_str(), &now) == 0 &&
             mine.st_ino == now.st_ino && mine.st_dev == now.st_dev;
    }

    /// Lock an open lock file.
    /// @return false if a running process has the lock
    bool
    hold(const int descriptor, const Owner &owner)
    {
      if (flock(descriptor, LOCK_EX | LOCK_NB) == 0)
        // Some network file systems lock on each host separately: a lock of another host is
        // respected.
        return owner.host.empty() || owner.host == host_name();
      if (errno == EWOULDBLOCK)
        return false;
      // A file system without locks: the process that the lock file names must not exist any more.
      return owner.process == 0 ||
             (owner.host == host_name() && kill(owner.process, 0) != 0 && errno == ESRCH);
    }

    /// @return the descriptor of the lock file, and the former owner if a process has ended without
    /// removing it. The loop repeats if another process has removed the file meanwhile. Throws
    /// SceneError.
    std::pair<int, Owner>
    take_lock(const std::string &directory, const std::string &file)
    {
      for (;;)
        {
          const int lock = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
          if (lock < 0)
            throw SceneError("Output/Directory = " + directory + ": it is not writable (" +
                             std::strerror(errno) + "); choose another directory");
          const Owner owner = owner_of(file);
          if (!hold(lock, owner))
            {
              close(lock);
              reject_locked(directory, file, owner);
            }
          if (is_there(lock, file))
            return {lock, owner};
          close(lock);
        }
    }

    /// Write this process into the lock file. Throws SceneError.
    void
    sign(const int lock, const std::string &file)
    {
      const std::string text = std::to_string(getpid()) + " " + host_name() + "\n";
      if (ftruncate(lock, 0) != 0 ||
          pwrite(lock, text.data(), text.size(), 0) != static_cast<ssize_t>(text.size()))
        throw SceneError("Output/Directory: cannot write " + file + ": " + std::strerror(errno));
    }
  } // namespace



  OutputDirectory::OutputDirectory(const std::string &path,
                                   const MPI_Comm     comm,
                                   const bool         is_restart)
    : path(path)
  {
    // All ranks have read the scene when they reach this point: the scene may be in this directory,
    // where files are removed. Rank 0 does the work, and its error is thrown on all ranks.
    MPI_Barrier(comm);
    std::string problem;
    if (Utilities::MPI::this_mpi_process(comm) == 0)
      try
        {
          create(path);
          const auto [descriptor, former] = take_lock(path, path + "/run.lock");
          lock                            = descriptor;
          sign(lock, path + "/run.lock");
          if (!is_restart)
            remove_stale_files(path);
          create(path + "/profiles");
          if (former.process > 0)
            my_note = "the run of " + former.text() + " did not end properly; " +
                      (is_restart ? "it goes on" : "its files in " + path + " are removed");
        }
      catch (const std::exception &error)
        {
          problem = error.what();
        }
    problem = Utilities::MPI::broadcast(comm, problem);
    my_note = Utilities::MPI::broadcast(comm, my_note);
    if (problem.empty())
      return;
    release();
    throw SceneError(problem);
  }



  void
  OutputDirectory::remove_steps_after(const unsigned int step) const
  {
    for (const fs::path &file : stale_files(path))
      if (step_of(file) > step)
        fs::remove(file);
    remove_empty_folders(path);
  }



  OutputDirectory::~OutputDirectory()
  {
    release();
  }



  void
  OutputDirectory::release()
  {
    if (lock < 0)
      return;
    unlink((path + "/run.lock").c_str());
    close(lock);
    lock = -1;
  }



  std::string
  mark_of_scene_file()
  {
    return "# Written by Signorini " SIGNORINI_VERSION
           ": the scene with all defaults; runs again as it is.\n";
  }



  void
  replace_file(const std::string &path, const std::string &text)
  {
    const std::string part = path + ".part";
    std::ofstream     out(part, std::ios::binary);
    out << text;
    out.close();
    std::error_code error;
    if (out)
      fs::rename(part, path, error);
    if (!out || error)
      throw OutputError(path, false);
  }
} // namespace Signorini
