// SPDX-License-Identifier: Apache-2.0
// Reads scenes, meshes, decks and formulas with mistakes in them, many thousands in one process.
// Each must be accepted or refused in the program's own words: no crash, no hang, no internal
// error, no leak, no file left behind, no more memory than a small file may ask for.
//
// What is found is kept in a folder with the reason; fuzz TARGET --file FILE reads it once more,
// and so does fuzz TARGET --seed S --first K --mutants 1.

#include "geometry/memory.h"
#include <signorini/parameters/raw.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/multithread_info.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <map>
#include <sstream>

#include "../unit/source_directory.h"
#include "limits.h"
#include "targets.h"

using namespace Fuzz;
namespace fs = std::filesystem;

namespace
{
  const std::string usage =
    R"(fuzz [TARGET...] [--mutants N] [--first K] [--seed S] [--seconds T] [--limit T] [--memory MIB]
     [--findings FOLDER]      N mutants, shared by the targets, from the K-th on, in T seconds at most;
                              none may take longer or more memory than the limits
fuzz TARGET --file FILE       read that file
)";

  struct Options
  {
    std::vector<std::string> targets;
    std::uint64_t            mutants = 10000, first = 0, seed = 1;
    double                   seconds = 1e9, limit = with_sanitizers ? 60 : 5;
    std::size_t              memory = 1024;
    std::string              file, findings = "fuzz-findings";
  };

  Options
  options_of(const std::vector<std::string> &words)
  {
    Options                                                               options;
    const std::map<std::string, std::function<void(const std::string &)>> setters = {
      {"--mutants", [&](const std::string &s) { options.mutants = std::stoull(s); }},
      {"--first", [&](const std::string &s) { options.first = std::stoull(s); }},
      {"--seed", [&](const std::string &s) { options.seed = std::stoull(s); }},
      {"--seconds", [&](const std::string &s) { options.seconds = std::stod(s); }},
      {"--limit", [&](const std::string &s) { options.limit = std::stod(s); }},
      {"--memory", [&](const std::string &s) { options.memory = std::stoull(s); }},
      {"--file", [&](const std::string &s) { options.file = fs::absolute(s); }},
      {"--findings", [&](const std::string &s) { options.findings = s; }}};
    for (std::size_t i = 0; i < words.size(); ++i)
      if (const auto setter = setters.find(words[i]); setter != setters.end())
        {
          if (++i == words.size())
            throw std::runtime_error(usage);
          setter->second(words[i]);
        }
      else if (words[i][0] == '-')
        throw std::runtime_error(usage);
      else
        options.targets.push_back(words[i]);
    return options;
  }



  /// What has come of the mutants of a target.
  struct Record
  {
    std::uint64_t mutants = 0, accepted = 0, refused = 0, defects = 0;
    double        longest = 0, seconds = 0;
    std::size_t   largest = 0; ///< bytes
  };

  /// In one line, and not without end.
  std::string
  in_one_line(const std::string &text)
  {
    std::istringstream in(text);
    std::string        line;
    for (std::string word; in >> word && line.size() < 600;)
      line += (line.empty() ? "" : " ") + word;
    return line.substr(0, 600);
  }



  /// What is wrong with a message that people should read, or nothing.
  std::string
  fault_of(const std::string &message)
  {
    constexpr std::size_t longest = 5000;
    if (message.empty())
      return "is refused without a word";
    if (message.size() > longest)
      return "is refused in " + std::to_string(message.size()) + " characters";
    const bool is_odd = std::any_of(message.begin(), message.end(), [](const unsigned char c) {
      return std::iscntrl(c) && c != '\n' && c != '\t';
    });
    return is_odd ? "is refused with control characters" : "";
  }



  class Run
  {
  public:
    explicit Run(const Options &options)
      : options(options)
      , findings(fs::absolute(options.findings))
      , scratch(source_directory())
      , watch(10 * options.limit)
    {
      fs::create_directories(findings);
    }

    Record
    read_mutants(const Target &target, const std::uint64_t n, const double seconds)
    {
      Record       record;
      const double end = processor_seconds() + seconds;
      for (std::uint64_t k = options.first; k < options.first + n; ++k)
        {
          const std::string how = target.name + " --seed " + std::to_string(options.seed) +
                                  " --first " + std::to_string(k) + " --mutants 1";
          read(target,
               mutant(target.stock, hash_of(target.name + std::to_string(options.seed)) + k),
               how,
               record);
          if (processor_seconds() > end)
            break;
        }
      record.seconds = processor_seconds() - (end - seconds);
      return record;
    }

    Record
    read_file(const Target &target)
    {
      Record             record;
      const double       begin = processor_seconds();
      std::ifstream      in(options.file, std::ios::binary);
      std::ostringstream text;
      text << in.rdbuf();
      read(target, text.str(), target.name + " --file " + options.file, record);
      record.seconds = processor_seconds() - begin;
      return record;
    }

  private:
    void
    read(const Target &target, const std::string &text, const std::string &how, Record &record)
    {
      const std::string file = "mutant" + target.extension;
      std::ofstream(file, std::ios::binary) << text;
      watch.begin(text, kept_as(target, text), "fuzz " + how);
      const std::size_t before = live_bytes();
      std::string       defect = attempt(target, text, file, record);
      if (defect.empty() && leaks(target, text, file, before))
        defect = "leaks: each time that it is read, more memory is taken";
      watch.end();
      for (const std::string &stranger : scratch.strangers(file))
        defect = "writes the file " + stranger;
      fs::remove(file);
      ++record.mutants;
      if (!defect.empty())
        {
          ++record.defects;
          keep(target, text, how, defect);
        }
    }

    /// What is wrong with it, or nothing.
    std::string
    attempt(const Target &target, const std::string &text, const std::string &file, Record &record)
    {
      const double begin = processor_seconds();
      limit_allocations(options.memory << 20);
      std::string defect = outcome(target, text, file, record);
      if (too_much_was_asked())
        defect = "asks for more than " + std::to_string(options.memory) + " MiB; " + defect;
      record.largest = std::max(record.largest, largest_allocation());
      limit_allocations(0);
      const double seconds = processor_seconds() - begin;
      record.longest       = std::max(record.longest, seconds);
      if (seconds > options.limit)
        defect = "takes " + std::to_string(seconds) + " s";
      return defect;
    }

    std::string
    outcome(const Target &target, const std::string &text, const std::string &file, Record &record)
    {
      try
        {
          target.read(file, text);
          ++record.accepted;
          return "";
        }
      catch (const Signorini::SceneError &error)
        {
          ++record.refused;
          return fault_of(error.what());
        }
      catch (const std::exception &error)
        {
          return "internal error: " + in_one_line(error.what());
        }
      catch (...)
        {
          return "internal error: something is thrown that is no exception";
        }
    }

    /// What is made once and kept for others is no leak.
    bool
    leaks(const Target      &target,
          const std::string &text,
          const std::string &file,
          std::size_t        before)
    {
      Record ignored;
      for (unsigned int time = 0; time < 3; ++time)
        {
          if (live_bytes() <= before)
            return false;
          before = live_bytes();
          attempt(target, text, file, ignored);
        }
      return live_bytes() > before;
    }

    fs::path
    kept_as(const Target &target, const std::string &text) const
    {
      std::ostringstream name;
      name << target.name << '-' << std::hex << hash_of(text) << target.extension;
      return findings / name.str();
    }

    /// Of defects that look alike a few.
    void
    keep(const Target      &target,
         const std::string &text,
         const std::string &how,
         const std::string &defect)
    {
      std::string kind = target.name + defect;
      kind.erase(std::remove_if(kind.begin(), kind.end(), [](char c) { return std::isdigit(c); }),
                 kind.end());
      if (++alike[kind.substr(0, 200)] > 3)
        return;
      const fs::path file = kept_as(target, text);
      std::ofstream(file, std::ios::binary) << text;
      const std::string report = "fuzz " + how + "\n  " + defect + "\n";
      std::ofstream(file.string() + ".txt") << report;
      std::cerr << "DEFECT " << report << "  kept as " << file.string() << std::endl;
    }

    const Options                       options;
    const fs::path                      findings;
    const Scratch                       scratch;
    Watch                               watch;
    std::map<std::string, unsigned int> alike;
  };



  void
  print_line(const std::string &name, const std::size_t n_seeds, const Record &record)
  {
    std::cerr << std::left << std::setw(9) << name << std::right << std::setw(7) << n_seeds
              << std::setw(10) << record.mutants << std::setw(10) << record.accepted
              << std::setw(10) << record.refused << std::setw(9) << record.defects << std::fixed
              << std::setprecision(2) << std::setw(13) << record.longest << std::setprecision(1)
              << std::setw(14) << record.largest / 1048576. << std::setprecision(0) << std::setw(14)
              << record.mutants / std::max(record.seconds, 1e-9) << std::endl;
  }

  void
  print_head()
  {
    std::cerr << "target     seeds   mutants  accepted   refused  defects  longest [s]"
                 "  most mem [MiB]  mutants a s\n";
  }

  void
  add(Record &sum, const Record &other)
  {
    sum.mutants += other.mutants;
    sum.accepted += other.accepted;
    sum.refused += other.refused;
    sum.defects += other.defects;
    sum.seconds += other.seconds;
    sum.longest = std::max(sum.longest, other.longest);
    sum.largest = std::max(sum.largest, other.largest);
  }



  std::vector<Target>
  chosen(const std::vector<std::string> &names)
  {
    std::vector<Target>      result;
    std::vector<std::string> known;
    for (const Target &target : all_targets(source_directory()))
      {
        known.push_back(target.name);
        if (names.empty() || std::count(names.begin(), names.end(), target.name) > 0)
          result.push_back(target);
      }
    for (const std::string &name : names)
      if (std::count(known.begin(), known.end(), name) == 0)
        throw std::runtime_error("there is no target " + name + "; there are " +
                                 Signorini::join(known) + "\n" + usage);
    return result;
  }



  int
  fuzz(const Options &options)
  {
    const std::vector<Target> targets = chosen(options.targets);
    if (!options.file.empty() && options.targets.size() != 1)
      throw std::runtime_error(usage);
    double shares = 0;
    for (const Target &target : targets)
      shares += target.share;
    Run         run(options);
    Record      sum;
    std::size_t n_seeds = 0;
    // Meshes that a small machine cannot hold are refused; what is left is quick.
    Signorini::memory_of_machine() = 1 << 24;
    if (!with_sanitizers)
      limit_addresses(4 * (options.memory << 20));
    // What the program says of files goes nowhere.
    std::streambuf *const spoken = std::cout.rdbuf(nullptr);
    print_head();
    for (const Target &target : targets)
      {
        const double part   = target.share / shares;
        const Record record = options.file.empty() ?
                                run.read_mutants(target,
                                                 std::max<std::uint64_t>(1, options.mutants * part),
                                                 options.seconds / targets.size()) :
                                run.read_file(target);
        print_line(target.name, target.stock.seeds.size(), record);
        add(sum, record);
        n_seeds += target.stock.seeds.size();
      }
    print_line("all", n_seeds, sum);
    std::cout.rdbuf(spoken);
    return sum.defects > 0;
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::MultithreadInfo::set_thread_limit(1);
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  // So that the run can go on.
  dealii::deal_II_exceptions::disable_abort_on_exception();
  try
    {
      return fuzz(options_of({argv + 1, argv + argc}));
    }
  catch (const std::exception &error)
    {
      std::cerr << error.what() << std::endl;
      return 2;
    }
}
