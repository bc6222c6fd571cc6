#include <signorini/mesh/generators/file.h>
#include <signorini/parameters/section.h>
#include <signorini/simulation.h>

#include <deal.II/base/mpi.h>

#include <filesystem>
#include <iostream>

using namespace Signorini;

namespace
{
  const std::string usage = R"(Signorini: elastic bodies in contact.

  signorini SCENE.prm [--set "Section/Key=value"]...   solve a scene
  signorini --check SCENE.prm [--set ...]              read and check it, report what would be solved
  signorini --print-template [2|3]                     a complete commented scene
  signorini --help | --version

In parallel: mpirun -np N signorini SCENE.prm. Exit codes: 0 solved, 1 internal error,
2 bad scene or command line, 3 not converged, 4 an expected result of the scene is missed.
)";

  struct Arguments
  {
    std::string              scene, action = "solve";
    std::vector<std::string> overrides;
    unsigned int             dimension = 2;
  };

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
      else if (words[i] == "--check" || words[i] == "--help" || words[i] == "--version")
        arguments.action = words[i].substr(2);
      else if (words[i] == "--print-template")
        {
          arguments.action = "template";
          if (i + 1 < words.size() && words[i + 1].substr(0, 1) != "-")
            {
              if (words[++i] != "2" && words[i] != "3")
                throw SceneError("--print-template " + words[i] + ": the dimension is 2 or 3");
              arguments.dimension = std::stoi(words[i]);
            }
        }
      else if (words[i].substr(0, 1) == "-")
        throw SceneError("unknown option '" + words[i] + "'\n\n" + usage);
      else if (!arguments.scene.empty())
        throw SceneError("two scenes: '" + arguments.scene + "' and '" + words[i] + "'");
      else
        arguments.scene = words[i];
    if (arguments.scene.empty() && (arguments.action == "solve" || arguments.action == "check"))
      throw SceneError("no scene is given\n\n" + usage);
    return arguments;
  }

  template <int dim>
  int
  run(RawSection &raw, const Arguments &arguments)
  {
    Scene<dim> scene;
    Section    section(raw);
    scene.declare(section);
    section.close();
    scene.given = raw;
    scene.name  = std::filesystem::path(arguments.scene).stem();
    scene.check();
    Simulation<dim> simulation(scene, MPI_COMM_WORLD);
    if (arguments.action == "solve")
      return simulation.run();
    simulation.preflight();
    return solved;
  }

  template <int dim>
  void
  print_template()
  {
    std::cout
      << "# A complete scene with all keys; values are defaults. Lengths, forces and times in any consistent units.\n";
    Section section(std::cout, true);
    Scene<dim>::example().declare(section);
  }

  int
  act(const Arguments &arguments, const bool first_rank)
  {
    if (arguments.action == "solve" || arguments.action == "check")
      {
        RawSection raw = read_raw(arguments.scene);
        for (const std::string &assignment : arguments.overrides)
          override_value(raw, assignment);
        mesh_search_path().push_back(std::filesystem::path(arguments.scene).parent_path());

        const RawSection::Value *dimension = raw.find_value("Dimension");
        if (!dimension)
          throw SceneError(arguments.scene +
                           ": 'Dimension' is not set; write set Dimension = 2 or 3 at the top");
        if (dimension->text == "2")
          return run<2>(raw, arguments);
        if (dimension->text == "3")
          return run<3>(raw, arguments);
        throw SceneError(dimension->where + ": Dimension = " + dimension->text +
                         ": must be 2 or 3");
      }
    if (first_rank && arguments.action == "help")
      std::cout << usage;
    else if (first_rank && arguments.action == "version")
      std::cout << "Signorini " << SIGNORINI_VERSION << "\n";
    else if (first_rank)
      arguments.dimension == 2 ? print_template<2>() : print_template<3>();
    return solved;
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const bool first_rank = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  try
    {
      return act(parse({argv + 1, argv + argc}), first_rank);
    }
  catch (const SceneError &error)
    {
      // All ranks read the same input and end here together.
      if (first_rank)
        std::cerr << "error: " << error.what() << std::endl;
      return bad_scene;
    }
  catch (const std::exception &error)
    {
      std::cerr << "internal error on rank "
                << dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) << ": " << error.what()
                << std::endl;
      // Other ranks may wait for this one forever.
      if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
        MPI_Abort(MPI_COMM_WORLD, internal_error);
      return internal_error;
    }
}
