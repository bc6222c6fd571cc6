// SPDX-License-Identifier: Apache-2.0
// What a run leaves behind against doc/guide/results.md: nothing undocumented, nothing documented
// that is not there; and the stress in all its forms against closed forms.
#include "driver/simulation.h"
#include "mesh_import/formats/vtu_data.h"
#include "scene/former_entries.h"
#include <signorini/parameters/section.h>

#include <doctest/doctest.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "source_directory.h"

using namespace Signorini;

namespace
{
  namespace fs = std::filesystem;

  std::string
  text_of(const fs::path &file)
  {
    std::ifstream     in(file);
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
  }

  /// A scene that was solved, its files, and what it printed.
  struct Solved
  {
    /// @param again and then restarted
    /// @param origin what the first run starts from
    template <int dim>
    Solved(std::integral_constant<int, dim>,
           const std::string &scene_text,
           const bool         again  = false,
           const RunOrigin    origin = RunOrigin::scene_file)
      : folder(fs::temp_directory_path() /
               ("signorini-results-" + std::to_string(getpid()) + "-" + std::to_string(count++)))
    {
      fs::remove_all(folder);
      fs::create_directories(folder);
      std::ofstream(folder / "test.prm") << scene_text;
      RawSection raw = read_raw((folder / "test.prm").string());
      override_value(raw, "Output/Directory=" + (folder / "out").string());
      Scene<dim> scene;
      Section    section(raw);
      scene.declare(section);
      section.close();
      scene.given = raw;
      scene.name  = "test";
      scene.read_files("");
      scene.check();

      std::ostringstream printed;
      std::streambuf    *screen = std::cout.rdbuf(printed.rdbuf());
      try
        {
          code = Simulation<dim>(scene, MPI_COMM_WORLD, std::cout, origin).run();
          if (again)
            code = Simulation<dim>(scene, MPI_COMM_WORLD, std::cout, RunOrigin::checkpoint).run();
        }
      catch (const std::exception &e)
        {
          error = e.what();
        }
      std::cout.rdbuf(screen);
      output  = printed.str();
      results = Json::parse(text_of(folder / "out" / "results.json"));
    }

    ~Solved()
    {
      fs::remove_all(folder);
    }

    static inline unsigned int count = 0;

    const fs::path folder;
    int            code = -1;
    std::string    output, error;
    Json           results;
  };

  using Two   = std::integral_constant<int, 2>;
  using Three = std::integral_constant<int, 3>;



  // The documentation ---------------------------------------------------------------------------

  /// The first column of the tables below a heading, which are in backticks.
  std::set<std::string>
  documented(const std::string &heading)
  {
    std::istringstream    page(text_of(source_directory() + "/doc/guide/results.md"));
    std::set<std::string> result;
    bool                  here = false;
    for (std::string line; std::getline(page, line);)
      {
        if (line.substr(0, 3) == "## ")
          here = line.substr(3) == heading;
        std::smatch cell;
        if (here && std::regex_search(line, cell, std::regex("^\\| (`[^|]*) \\|")))
          {
            const std::string names = cell[1].str();
            const std::regex  name("`([^`]*)`");
            for (std::sregex_iterator i(names.begin(), names.end(), name), end; i != end; ++i)
              result.insert((*i)[1].str());
          }
      }
    return result;
  }

  /// What stands for the names that a user or a library chooses, by what they stand under.
  const std::map<std::string, std::string> stands_for = {{"load_steps/N/pairs", "PAIR"},
                                                         {"load_steps/N/supports", "SUPPORT"},
                                                         {"load_steps/N/obstacles", "OBSTACLE"},
                                                         {"degrees", "BODY"},
                                                         {"load_steps/N/bodies", "BODY"},
                                                         {"load_steps/N/probes", "PROBE"},
                                                         {"load_steps/N/fluids", "LOAD"},
                                                         {"load_steps/N/cross_sections", "SECTION"},
                                                         {"preflight/bodies", "BODY"},
                                                         {"preflight/bodies/BODY/boundaries",
                                                          "BOUNDARY"},
                                                         {"preflight/pairs", "PAIR"},
                                                         {"accuracy/quantities", "QUANTITY"},
                                                         {"expected", "RESULT"},
                                                         {"seconds", "PHASE"},
                                                         {"deprecated/entries", "ENTRY"},
                                                         {"deprecated/checks", "CHECK"},
                                                         {"libraries", "LIBRARY"}};

  void
  collect_paths(const Json &value, const std::string &path, std::set<std::string> &paths)
  {
    const auto below = [&](const std::string &part) {
      return path.empty() ? part : path + "/" + part;
    };
    // The page says it once.
    if (path == "cycles/N/accuracy" || path == "load_steps/N/accuracy")
      return collect_paths(value, "accuracy", paths);
    if (path == "load_steps/N/probes/PROBE/N")
      return collect_paths(value, "load_steps/N/probes/PROBE", paths);
    const auto names = stands_for.find(path);
    if (value.is_object())
      for (const auto &[key, inner] : value.items())
        collect_paths(inner, below(names == stands_for.end() ? key : names->second), paths);
    else if (value.is_array() && !value.empty() && value.front().is_object())
      for (const Json &inner : value)
        collect_paths(inner, below("N"), paths);
    else if (!value.is_array() || !value.empty() || (path != "cycles" && path != "load_steps"))
      paths.insert(path);
  }

  /// f(object) for all objects at a path in which `*` stands for any part.
  template <typename F>
  void
  at_all(Json &tree, const std::vector<std::string> &path, const unsigned int first, const F &f)
  {
    if (first == path.size())
      return f(tree);
    for (auto &[key, inner] : tree.items())
      if (path[first] == "*" || path[first] == key)
        at_all(inner, path, first + 1, f);
  }

  /// What is there under a former name is there under the present one.
  Json
  without_former_names(Json results)
  {
    for (const auto &[parent, former, now] : former_entries())
      at_all(results, split(parent, '/'), 0, [former = former, now = now](Json &object) {
        if (object.is_object())
          {
            CHECK(object.contains(former) == object.contains(now));
            CHECK(object.value(former, Json()) == object.value(now, Json()));
            object.erase(former);
          }
      });
    const Json verdict = results.value("verdict", Json{{"checks", Json::array()}});
    for (const Json &check : verdict["checks"])
      for (const auto &[former, now] : former_checks())
        CHECK(check["check"] != former);
    return results;
  }

  std::set<std::string>
  fields_of(const fs::path &vtu)
  {
    const std::string     text = text_of(vtu);
    const std::regex      name("Name=\"([^\"]*)\"");
    std::set<std::string> result;
    for (std::sregex_iterator i(text.begin(), text.end(), name), end; i != end; ++i)
      result.insert((*i)[1].str());
    for (const char *of_the_mesh : {"connectivity", "offsets", "types"})
      result.erase(of_the_mesh);
    return result;
  }

  std::vector<float>
  values_of(const fs::path &vtu, const std::string &field)
  {
    const std::string text = text_of(vtu), mark = "Name=\"" + field + "\"";
    const auto        at = text.find('>', text.find(mark)) + 1;
    const std::string bytes =
      VtuData(false, "vtkZLibDataCompressor").from_base64(text.substr(at, text.find('<', at) - at));
    std::vector<float> result(bytes.size() / sizeof(float));
    std::memcpy(result.data(), bytes.data(), bytes.size());
    return result;
  }

  std::set<std::string>
  without(const std::set<std::string> &a, const std::set<std::string> &b)
  {
    std::set<std::string> result;
    std::set_difference(
      a.begin(), a.end(), b.begin(), b.end(), std::inserter(result, result.begin()));
    return result;
  }

  std::string
  listed(const std::set<std::string> &names)
  {
    return join({names.begin(), names.end()});
  }



  // Scenes --------------------------------------------------------------------------------------

  std::string
  box(const std::string &name, const std::string &corners, const std::string &cells)
  {
    return "subsection " + name + "\nset Mesh = box\nset Corners = " + corners +
           "\nset Subdivisions = " + cells +
           "\nset Young's modulus = 100\nset Poisson's ratio = 0.25\nend\n";
  }

  /// Two blocks under a plate with a force, free to slide; two load steps.
  const std::string blocks =
    "set Dimension = 2\nsubsection Bodies\nset Names = lower, upper\n" +
    box("lower", "0,0 : 4,1", "8,2") + box("upper", "1,1 : 3,2", "3,2") +
    "end\nsubsection Obstacles\nset Names = plate\nsubsection plate\nset Shape = plane\nset Point = "
    "0,2\nset Normal = 0,-1\nset Displacement = 0; free\nset Force = 0; -t\nend\nend\n"
    "subsection Supports\nset Names = base\nsubsection base\nset Boundaries = lower.bottom\nset "
    "Displacement = 0; 0\nend\nend\nsubsection Contact pairs\nset Names = joint, head\nsubsection "
    "joint\nset Extent directions = 1, 1\nset Slave = upper.bottom\nset Master = lower.top\nend\nsubsection head\nset Slave = "
    "upper.top\nset Master = plate\nend\nend\nsubsection Newton\nset Unconstrained modes = "
    "stabilise\nend\nsubsection Load steps\nset Number = 2\nend\nsubsection Output\nsubsection "
    "Probes\nset Names = middle, across\nsubsection middle\nset Body = lower\nset Point = 2, "
    "0.5\nend\nsubsection across\nset Pair = joint\nset Point = 1, 1\nset End = 2, 1\nset Points = "
    "3\nend\nend\nsubsection Cross sections\nset Names = cut\nsubsection cut\nset Bodies = lower\nset Point = 2, "
    "0.5\nset Normal = 0, 1\nend\nend\nend\n";

  std::string
  replaced(std::string text, const std::string &old, const std::string &by)
  {
    const auto at = text.find(old);
    REQUIRE(at != std::string::npos);
    return text.replace(at, old.size(), by);
  }

  /// The blocks with friction, and automatic load steps.
  std::string
  with_friction()
  {
    return replaced(replaced(blocks,
                             "subsection joint\n",
                             "subsection joint\nset Friction = 0.1\n"),
                    "set Number = 2",
                    "set Number = automatic\nset Path error = 0.1");
  }

  /// A block on rollers that a plane presses by 1 %: all its stress is sigma_yy = -1 in plane
  /// stress, in space sigma_zz. The plane is z = 0 (y = 0) and the block lies on it.
  template <int dim>
  std::string
  pressed_block()
  {
    const bool        flat = dim == 2;
    const std::string up   = flat ? "0,1" : "0,0,1";
    std::string       text =
      std::string("set Dimension = ") + (flat ? "2\nset Model = plane stress\n" : "3\n") +
      "subsection Bodies\nset Names = block\n" +
      (flat ? box("block", "0,0 : 2,1", "2,2") : box("block", "0,0,0 : 2,2,1", "2,2,2")) +
      "end\nsubsection Obstacles\nset Names = ground\nsubsection ground\nset Shape = plane\nset Point = " +
      (flat ? "0,0" : "0,0,0") + "\nset Normal = " + up +
      "\nend\nend\nsubsection Supports\nset Names = press, side" + (flat ? "" : ", back") +
      "\nsubsection press\nset Boundaries = block.top\nset Displacement = " +
      (flat ? "free; -0.01" : "free; free; -0.01") +
      "\nend\nsubsection side\nset Type = symmetry\nset Boundaries = block.left\nend\n" +
      (flat ? "" : "subsection back\nset Type = symmetry\nset Boundaries = block.front\nend\n") +
      "end\nsubsection Contact pairs\nset Names = foot\nsubsection foot\nset Slave = block.bottom\n"
      "set Master = ground\nend\nend\nsubsection Output\nset Strain = yes\nset Linear reference = yes\nsubsection "
      "Probes\nset Names = middle, under\nsubsection middle\nset Point = " +
      (flat ? "1, 0.5" : "1, 1, 0.5") +
      "\nend\nsubsection under\nset Pair = foot\nset Points = 4\nset Point = " +
      (flat ? "0, 0.1\nset End = 2, 0" : "0, 0, 0.1\nset End = 2, 1.5, 0") +
      "\nend\nend\nend\nsubsection Accuracy\nset Refinement cycles = 1\nend\nsubsection Known "
      "solution\nset Pressure = 1\nset Volumetric stress = 0\nset Displacement = " +
      (flat ? "0.0025*x; -0.01*y" : "0.0025*x; 0.0025*y; -0.01*z") +
      "\nend\nsubsection Expected results\nset Names = force\nsubsection force\nset Quantities = F = "
      "pairs/foot/force/" +
      (flat ? "1" : "2") + "\nset Value = F\nset Reference = " + (flat ? "2" : "4") +
      "\nset Tolerance = 1e-6\nend\nend\n";
    return text;
  }
} // namespace



TEST_CASE("doc/guide/results.md describes what is written, and all of that is written")
{
  const std::string warm = replaced(blocks,
                                    "end\nsubsection upper",
                                    "set Thermal expansion = 1e-9\nset Temperature = 1\nend\n"
                                    "subsection upper"),
                    wet  = replaced(warm,
                                   "subsection Supports\n",
                                   "subsection Loads\nset Names = water\nsubsection water\nset "
                                    "Boundaries = lower.right\nset Pressure = 1e-3\nset Fluid "
                                    "entry = 4, 0\nend\nend\nsubsection Supports\n");
  const std::string hopeless =
    replaced(blocks, "subsection Newton\n", "subsection Newton\nset Maximum steps = 1\n");
  const std::string wanted = replaced(blocks,
                                      "subsection Newton\n",
                                      "subsection Accuracy\nset Quantity = motion y of plate\nset "
                                      "Target error = 5e-3\nend\nsubsection Newton\n");
  const Solved      accurate(Two(), wanted), open(Two(), "set Deformation = automatic\n" + blocks);
  REQUIRE(open.code == solved);
  REQUIRE(accurate.code == solved);
  REQUIRE(accurate.results["accuracy"]["met"] == true);
  const Solved rough(Two(), with_friction());
  REQUIRE(rough.code == solved);
  const Solved tied(Two(),
                    replaced(blocks,
                             "subsection joint\n",
                             "subsection joint\nset Law = tied\nset Shortening = 0\n"));
  REQUIRE(tied.code == solved);
  const Solved bonded(Two(),
                      replaced(blocks,
                               "subsection joint\n",
                               "subsection joint\nset Law = tied\nset Strength = 1e9\n"));
  REQUIRE(bonded.code == solved);
  const Solved one(Two(), wet), two(Two(), pressed_block<2>()), three(Three(), pressed_block<3>()),
    failed(Two(), hopeless, true);
  REQUIRE(one.code == solved);
  REQUIRE(two.code == solved);
  REQUIRE(three.code == solved);
  REQUIRE(failed.code == not_converged);

  std::set<std::string> paths;
  for (const Solved *run : {&one, &two, &three, &failed, &accurate, &open, &rough, &tied, &bonded})
    collect_paths(without_former_names(run->results), "", paths);
  const std::set<std::string> page = documented("results.json");
  CHECK_MESSAGE(without(paths, page).empty(),
                "doc/guide/results.md lacks, under results.json: ",
                listed(without(paths, page)));
  CHECK_MESSAGE(without(page, paths).empty(),
                "doc/guide/results.md has what results.json lacks: ",
                listed(without(page, paths)));
}



TEST_CASE("doc/guide/results.md describes the fields of VTU files and the columns of profiles")
{
  const Solved   run(Two(), pressed_block<2>());
  const fs::path out = run.folder / "out";
  CHECK(listed(fields_of(out / "solution_0001.0.vtu")) == listed(documented("solution.pvd")));
  const Solved rough(Two(), with_friction());
  CHECK(listed(fields_of(rough.folder / "out" / "contact_0001.0.vtu")) ==
        listed(documented("contact.pvd")));

  // A known solution adds a column, and friction others.
  std::set<std::string> columns;
  for (const fs::path &folder : {out, rough.folder / "out"})
    for (const auto &profile : fs::directory_iterator(folder / "profiles"))
      if (profile.path().extension() == ".csv")
        {
          std::istringstream file(text_of(profile.path()));
          std::string        header;
          std::getline(file, header);
          for (const std::string &column : split(header, ','))
            columns.insert(column);
        }
  CHECK(listed(columns) == listed(documented("Profiles")));
}



TEST_CASE_TEMPLATE("uniaxial stress as a tensor, by names, principal and as a traction",
                   Dimension,
                   Two,
                   Three)
{
  constexpr int  dim = Dimension::value;
  const Solved   run(Dimension(), pressed_block<dim>());
  const fs::path out = run.folder / "out";
  REQUIRE(run.code == solved);

  const Json       &probe  = run.results["load_steps"].back()["probes"]["middle"];
  const std::string normal = dim == 2 ? "yy" : "zz";
  REQUIRE(probe["stress"].size() == 6);
  for (const auto &[name, value] : probe["stress"].items())
    CHECK(value.template get<double>() == doctest::Approx(name == normal ? -1 : 0).epsilon(1e-8));
  for (unsigned int i = 0; i < 3; ++i)
    CHECK(probe["principal_stress"][i].template get<double>() ==
          doctest::Approx(i == 2 ? -1 : 0).epsilon(1e-8));
  // Poisson's ratio is 1/4.
  REQUIRE(probe["strain"].size() == 6);
  for (const auto &[name, value] : probe["strain"].items())
    CHECK(value.template get<double>() == doctest::Approx(name == normal     ? -0.01 :
                                                          name[0] == name[1] ? 0.0025 :
                                                                               0)
                                            .epsilon(1e-8));
  for (unsigned int i = 0; i < 3; ++i)
    CHECK(probe["principal_strain"][i].template get<double>() ==
          doctest::Approx(i == 2 ? -0.01 : 0.0025).epsilon(1e-8));

  const Json &under = run.results["load_steps"].back()["probes"]["under"];
  REQUIRE(under.size() == 4);
  for (unsigned int i = 0; i < 4; ++i)
    {
      CHECK(under[i]["pressure"].template get<double>() == doctest::Approx(1).epsilon(1e-8));
      CHECK(std::abs(under[i]["gap"].template get<double>()) < 1e-9);
      CHECK(std::abs(under[i]["place"][dim - 1].template get<double>()) < 1e-12);
      CHECK(under[i]["place"][0].template get<double>() == doctest::Approx(2. / 3 * i));
      CHECK(under[i]["displacement"][0].template get<double>() ==
            doctest::Approx(0.0025 * 2. / 3 * i).epsilon(1e-8));
    }

  const std::vector<float> tensor    = values_of(out / "solution_0001.0.vtu", "stress"),
                           least     = values_of(out / "solution_0001.0.vtu", "principal_stress_3"),
                           largest   = values_of(out / "solution_0001.0.vtu", "principal_stress_1"),
                           strain    = values_of(out / "solution_0001.0.vtu", "strain"),
                           shortest  = values_of(out / "solution_0001.0.vtu", "principal_strain_3"),
                           traction  = values_of(out / "contact_0001.0.vtu", "traction"),
                           pressures = values_of(out / "contact_0001.0.vtu", "pressure");
  REQUIRE(tensor.size() == 9 * least.size());
  REQUIRE(!least.empty());
  for (std::size_t i = 0; i < tensor.size(); ++i)
    CHECK(tensor[i] == doctest::Approx(i % 9 == (dim == 2 ? 4 : 8) ? -1 : 0).epsilon(1e-5));
  for (std::size_t i = 0; i < least.size(); ++i)
    {
      CHECK(least[i] == doctest::Approx(-1).epsilon(1e-5));
      CHECK(largest[i] == doctest::Approx(0).epsilon(1e-5));
    }
  REQUIRE(strain.size() == tensor.size());
  for (std::size_t i = 0; i < strain.size(); ++i)
    CHECK(strain[i] == doctest::Approx(i % 9 % 4 > 0               ? 0 :
                                       i % 9 == (dim == 2 ? 4 : 8) ? -0.01 :
                                                                     0.0025)
                         .epsilon(1e-5));
  for (const float value : shortest)
    CHECK(value == doctest::Approx(-0.01).epsilon(1e-5));
  // The ground pushes the block up.
  REQUIRE(traction.size() == 3 * pressures.size());
  REQUIRE(!pressures.empty());
  for (std::size_t i = 0; i < traction.size(); ++i)
    CHECK(traction[i] == doctest::Approx(i % 3 == dim - 1 ? 1 : 0).epsilon(1e-5));
}



TEST_CASE("names of bodies and pairs stand in the VTU files, in the order of their numbers")
{
  const Solved run(Two(), blocks);
  const auto   words = [&](const std::string &file, const std::string &field) {
    const std::string  text = text_of(run.folder / "out" / file);
    const auto         at   = text.find('>', text.find("Name=\"" + field + "\"")) + 1;
    std::istringstream codes(text.substr(at, text.find('<', at) - at));
    std::string        result;
    for (int code; codes >> code;)
      result += code == 0 ? '|' : static_cast<char>(code);
    return result;
  };
  CHECK(words("solution_0002.0.vtu", "body_names") == "lower|upper|");
  CHECK(words("contact_0002.0.vtu", "pair_names") == "joint|head|");
}



TEST_CASE("each load step has its profiles, and the last is there under the name of the pair")
{
  const Solved   run(Two(), blocks);
  const fs::path profiles = run.folder / "out" / "profiles";
  for (const char *name : {"joint.csv", "head.csv"})
    {
      const std::string first = text_of(profiles / "step-0001" / name),
                        last  = text_of(profiles / "step-0002" / name);
      CHECK(!first.empty());
      CHECK(first != last);
      CHECK(text_of(profiles / name) == last);
    }
  CHECK(run.results["load_steps"].size() == 2);
  CHECK(run.results["load_steps"][1]["step"] == 2);
}



TEST_CASE("a run that is refused late leaves results that say so")
{
  const Solved run(Two(), replaced(blocks, "modes = stabilise", "modes = error"));
  CHECK(run.code == -1);
  CHECK(run.error.find("no support constrains") != std::string::npos);
  CHECK(run.results["converged"] == false);
  CHECK(run.results["reason"] == run.error);
  CHECK(!fs::exists(run.folder / "out" / "run.lock"));
}



// A program may put classes of its own into a scene, in whose place a restart would read others.
TEST_CASE("the run of a program cannot be restarted, and its scene.prm says what it lacks")
{
  const auto files = [](const RunOrigin origin) {
    const Solved run(Two(), blocks, false, origin);
    return std::make_pair(
      fs::exists(run.folder / "out" / "restart.scene"),
      text_of(run.folder / "out" / "scene.prm").find("# The scene of a program"));
  };
  const auto of_file = files(RunOrigin::scene_file), of_program = files(RunOrigin::program);
  CHECK(of_file.first);
  CHECK(of_file.second == std::string::npos);
  CHECK_FALSE(of_program.first);
  CHECK(of_program.second != std::string::npos);
}
