// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/decks/import_deck.h"
#include "scene/documentation.h"
#include <signorini/driver/run_scene.h>
#include <signorini/parameters/raw.h>

#include <deal.II/base/multithread_info.h>

#include <cstdlib>
#include <iostream>

using namespace Signorini;

namespace
{
  const std::string usage = R"(Signorini: elastic bodies in contact.

  signorini SCENE.prm [--set "Section/Key=value"]...   solve a scene
  signorini --strict SCENE.prm [--set ...]             the same; warnings about the answer are failures
  signorini --restart DIRECTORY [--set ...]            go on with a run that was ended, from the last checkpoint in its
                                                       output directory, on any number of ranks
  signorini --check SCENE.prm [--set ...]              read and check it, report what would be solved
  signorini --import DECK.inp                          the scene that a deck of Abaqus or CalculiX describes
  signorini --print-template [2|3] [--set ...]         a complete commented scene
  signorini --print-template [2|3] WORDS...            its parts about a mesh, an obstacle's shape, a method,
                                                       a preconditioner, a section: ring plane penalty "Load steps"
  signorini --print-reference                          all keys, as doc/guide/reference.md
  signorini --help | --version

In parallel: mpirun -np N signorini SCENE.prm. Exit codes: 0 solved, 1 internal error or full disk,
2 bad scene or command line, 3 not converged, or no answer by the verdict, 4 an expected result of the scene is missed,
5 ended by SIGTERM, SIGINT, SIGUSR1 or its time limit, with a checkpoint.
)";

  /// The command line, parsed.
  struct Arguments
  {
    std::string              scene, restart, action = "solve";
    std::vector<std::string> overrides;
    TemplateRequest          wanted;
  };

  /// Parse the words of the command line. Throws SceneError for unknown options and combinations
  /// that make no sense.
  Arguments
  parse(const std::vector<std::string> &words)
  {
    Arguments arguments;
    for (std::size_t i = 0; i < words.size(); ++i)
      if (words[i] == "--set")
        {
          if (++i == words.size())
            throw SceneError("--set needs \"Section/Key=value\"");
          arguments.overrides.push_back(words[i]);
        }
      else if (words[i] == "--strict")
        arguments.overrides.push_back("Output/Strict=yes");
      else if (words[i] == "--check" || words[i] == "--help" || words[i] == "--version" ||
               words[i] == "--print-reference")
        arguments.action = words[i].substr(2);
      else if (words[i] == "--restart")
        {
          if (++i == words.size())
            throw SceneError("--restart needs the output directory of a run");
          arguments.restart = words[i];
        }
      else if (words[i] == "--import")
        {
          if (++i == words.size())
            throw SceneError("--import needs an input file of Abaqus or CalculiX");
          arguments.action = "import";
          arguments.scene  = words[i];
        }
      else if (words[i] == "--print-template")
        {
          arguments.action = "print-template";
          while (i + 1 < words.size() && words[i + 1].substr(0, 1) != "-")
            arguments.wanted.words.push_back(words[++i]);
        }
      else if (words[i].substr(0, 1) == "-")
        throw SceneError("unknown option '" + words[i] + "'\n\n" + usage);
      else if (!arguments.scene.empty())
        throw SceneError("two scenes: '" + arguments.scene + "' and '" + words[i] + "'");
      else
        arguments.scene = words[i];
    TemplateRequest &wanted = arguments.wanted;
    if (!wanted.words.empty() && (wanted.words[0] == "2" || wanted.words[0] == "3"))
      {
        wanted.dimension = std::stoi(wanted.words[0]);
        wanted.words.erase(wanted.words.begin());
      }
    wanted.overrides = arguments.overrides;
    if (!arguments.restart.empty() && (!arguments.scene.empty() || arguments.action != "solve"))
      throw SceneError(
        "--restart DIRECTORY continues the scene of that directory; it can be combined with --set only");
    if (arguments.restart.empty() && arguments.scene.empty() &&
        (arguments.action == "solve" || arguments.action == "check"))
      throw SceneError("no scene is given\n\n" + usage);
    return arguments;
  }

  /// True if mpirun or the like has started this process, perhaps as one of several.
  bool
  was_launched()
  {
    for (const char *name : {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK", "SLURM_PROCID"})
      if (std::getenv(name))
        return true;
    return false;
  }

  /// Set environment variables of Open MPI for a process that runs alone, so that it starts no
  /// daemon (Open MPI 4) and opens no network; variables that are set are kept. Returns true.
  bool
  prepare_environment()
  {
    if (!was_launched())
      for (const auto &[name, value] : {std::pair("OMPI_MCA_ess_singleton_isolated", "1"),
                                        std::pair("OMPI_MCA_pml", "ob1"),
                                        std::pair("OMPI_MCA_btl", "self")})
        setenv(name, value, 0);
    return true;
  }

  /// Initialises MPI and the libraries that need it, with an empty command line, in which they
  /// would otherwise look for options of their own.
  class Libraries
  {
  public:
    Libraries()
      : is_prepared(prepare_environment())
      , mpi(n_words, words, 1)
    {}

  private:
    const bool                               is_prepared;
    char                                     name[10] = "signorini";
    char                                    *list[2]  = {name, nullptr};
    char                                   **words    = list;
    int                                      n_words  = 1;
    dealii::Utilities::MPI::MPI_InitFinalize mpi;
  };

  /// Do what the command line asks for. @param libraries initialised if the action needs MPI;
  /// @param speaks true on the rank that writes messages
  /// @return the exit code
  int
  act(const Arguments &arguments, std::unique_ptr<Libraries> &libraries, const bool speaks)
  {
    if (arguments.action == "solve" || arguments.action == "check")
      {
        const auto scene = PreparedScene::read(
          {arguments.scene, arguments.overrides, arguments.action == "check", arguments.restart});
        if (!libraries)
          libraries = std::make_unique<Libraries>();
        return scene->run(MPI_COMM_WORLD, std::cout);
      }
    if (speaks && arguments.action == "import")
      import_deck(arguments.scene, std::cout, std::cerr);
    else if (speaks && arguments.action == "help")
      std::cout << usage;
    else if (speaks && arguments.action == "version")
      std::cout << "Signorini " << SIGNORINI_VERSION << "\n";
    else if (speaks && arguments.action == "print-reference")
      print_reference(std::cout);
    else if (speaks)
      print_template(arguments.wanted, std::cout);
    return solved;
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::MultithreadInfo::set_thread_limit(1);
  // Starting MPI takes longer than rejecting a faulty scene, so that it is started later if this
  // process is alone. Of several ranks one writes the messages for all, and none may have exited
  // before.
  std::unique_ptr<Libraries> libraries;
  if (was_launched())
    libraries = std::make_unique<Libraries>();
  const bool speaks = !libraries || dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  return exit_code_of(
    [&] {
      return act(parse({argv + 1, argv + argc}), libraries, speaks);
    },
    speaks,
    std::cerr);
}
