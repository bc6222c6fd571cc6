// SPDX-License-Identifier: Apache-2.0
#include "targets.h"

#include "contact/obstacles/triangle_surface.h"
#include "mesh/mesh.h"
#include "mesh_import/decks/import_deck.h"
#include "parameters/compiled_formula.h"
#include "scene/documentation.h"
#include <signorini/driver/run_scene.h>
#include <signorini/parameters/section.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

namespace Fuzz
{
  using namespace dealii;
  using namespace Signorini;
  namespace fs = std::filesystem;

  namespace
  {
    constexpr std::size_t largest_seed = 1 << 15; // bytes: larger ones are slow, and say no more

    std::string
    contents(const fs::path &file)
    {
      std::ifstream in(file, std::ios::binary);
      return {std::istreambuf_iterator<char>(in), {}};
    }

    /// In an order that is the same everywhere.
    std::vector<fs::path>
    files_in(const fs::path &folder, const std::string &extension)
    {
      std::vector<fs::path> files;
      for (const auto &entry : fs::directory_iterator(folder))
        if (entry.path().extension() == extension && entry.file_size() <= largest_seed)
          files.push_back(entry.path());
      std::sort(files.begin(), files.end());
      return files;
    }

    std::vector<std::string>
    seeds_of(const std::string              &sources,
             const std::vector<std::string> &folders,
             const std::string              &extension,
             const std::set<std::string>    &without = {})
    {
      std::vector<std::string> seeds;
      for (const std::string &folder : folders)
        for (const fs::path &file : files_in(fs::path(sources) / folder, extension))
          if (without.count(file.stem()) == 0)
            seeds.push_back(contents(file));
      return seeds;
    }

    /// Parts of a file that empty lines separate.
    std::vector<std::string>
    paragraphs(const std::string &file)
    {
      std::vector<std::string> result(1);
      std::ifstream            in(file);
      for (std::string line; std::getline(in, line);)
        if (line.empty())
          result.emplace_back();
        else
          result.back() += (result.back().empty() ? "" : "\n") + line;
      return result;
    }

    std::vector<std::string>
    lines_of(const std::string &text)
    {
      std::vector<std::string> lines;
      std::istringstream       in(text);
      for (std::string line; std::getline(in, line);)
        lines.push_back(line);
      return lines;
    }

    /// Words of the seeds, and others.
    Stock
    stock(const std::vector<std::string> &seeds, const std::vector<std::string> &others = {})
    {
      std::set<std::string> words(others.begin(), others.end());
      for (const std::string &seed : seeds)
        {
          std::istringstream in(seed);
          for (std::string word; in >> word;)
            if (word.size() < 40 && std::isalpha(static_cast<unsigned char>(word.back())))
              words.insert(word);
        }
      return {seeds, {words.begin(), words.end()}};
    }



    void
    read_scene(const std::string &file, const std::string &)
    {
      PreparedScene::read({file, {}, true});
    }



    /// All that --check does: meshes, contact, predictions.
    void
    check_scene(const std::string &file, const std::string &)
    {
      std::ostringstream out;
      const auto         scene = PreparedScene::read({file, {}, true});
      scene->run(MPI_COMM_WORLD, out);
    }



    /// The keys of a body with this file as its mesh. What is wanted of the file is another in each
    /// mutant, and the same whenever it is read.
    RawSection
    body_of(const std::string &file, const std::string &text)
    {
      Random     random(hash_of(text));
      RawSection raw;
      const auto set = [&](const std::string &key, const std::vector<std::string> &values) {
        const std::string &value = values[random.below(values.size())];
        if (!value.empty())
          raw.set_value(key, value, "fuzz");
      };
      set("Mesh", {"file"});
      set("File", {file});
      set("Coinciding nodes", {"error", "merge", "keep"});
      set("Feature angle", {"", "30", "180"});
      set("Mid-side nodes", {"yes", "yes", "no"});
      set("Curved boundaries", {"", "automatic", "none"});
      set("Node distance", {"", "", "1e-3", "1"});
      // Few files have these.
      if (random.one_in(8))
        set("Part", {"piece1", "block", "region 1", "E"});
      if (random.one_in(8))
        set("Temperature field", {"heat"});
      return raw;
    }

    template <int dim>
    void
    read_body(const std::string &file, const std::string &text)
    {
      RawSection    raw = body_of(file, text);
      Section       section(raw);
      BodyMesh<dim> body;
      body.declare(section);
      section.close();
      body.generator->read_file("", "");
      const CoarseMesh<dim> coarse = body.generator->generate();
      for (const std::string &name : body.generator->node_sets())
        body.generator->node_set(name);
      if (coarse.cells.size() < 200 && hash_of(text) % 4 == 0)
        Mesh<dim>({{"body", body}}, {}, {}, MPI_COMM_WORLD);
    }

    void
    read_mesh(const std::string &file, const std::string &text)
    {
      try
        {
          read_body<3>(file, text);
        }
      catch (const SceneError &)
        {
          read_body<2>(file, text);
        }
    }



    void
    read_surface(const std::string &file, const std::string &)
    {
      const TriangleSurface surface(read_stl(file));
      for (const Point<3> &x : {Point<3>(), Point<3>(0.1, 0.2, 0.3), Point<3>(-10, 1e6, 3)})
        surface.closest(x);
    }



    /// And the scene that comes of it.
    void
    import(const std::string &file, const std::string &)
    {
      std::ostringstream messages;
      const std::string  scene = fs::path(file).replace_extension(".prm");
      {
        std::ofstream out(scene);
        import_deck(file, out, messages);
      }
      PreparedScene::read({scene, {}, true});
    }



    /// The first line is a formula of the place and the time, the others are definitions.
    void
    read_formula(const std::string &, const std::string &text)
    {
      std::vector<std::string> lines       = lines_of(text);
      const auto               definitions = std::make_shared<Definitions>();
      lines.resize(std::max<std::size_t>(lines.size(), 1));
      for (std::size_t i = 1; i < lines.size(); ++i)
        {
          const auto equal = lines[i].find('=');
          if (equal != std::string::npos)
            definitions->add(trim(lines[i].substr(0, equal)), trim(lines[i].substr(equal + 1)));
        }
      const Formula formula(lines[0], definitions);
      if (lines[0].find(';') != std::string::npos)
        {
          VectorExpression<3>(formula).value({0.1, 0.2, 0.3}, 0.4);
          return;
        }
      const CompiledFormula compiled(formula, {"x", "y", "z", "t"});
      for (const double a : {0., 0.5, -1e300, std::nan("")})
        {
          const double values[] = {a, a + 1, 2 * a, a};
          compiled.value(values);
        }
    }



    /// Each line is what stands behind --set, or words behind --print-template if it has no `=`.
    void
    read_settings(const std::string &, const std::string &text)
    {
      TemplateRequest wanted;
      for (const std::string &line : lines_of(text))
        if (line.find('=') != std::string::npos)
          wanted.overrides.push_back(line);
        else
          for (const std::string &word : split(line, ' '))
            wanted.words.push_back(word);
      if (wanted.words.empty())
        PreparedScene::read({"two-cells.prm", wanted.overrides, true});
      if (!wanted.words.empty() && (wanted.words[0] == "2" || wanted.words[0] == "3"))
        {
          wanted.dimension = wanted.words[0] == "2" ? 2 : 3;
          wanted.words.erase(wanted.words.begin());
        }
      std::ostringstream out;
      print_template(wanted, out);
    }
  } // namespace



  std::vector<Target>
  all_targets(const std::string &sources)
  {
    const std::string              own    = sources + "/tests/fuzz/seeds";
    const std::vector<std::string> meshes = {"meshes", "tests/meshes", "tests/fuzz/seeds"};
    // Scenes whose check takes more than a tenth of a second.
    const std::set<std::string>    slow   = {"ball-between-plates",
                                             "ball-on-block",
                                             "block-on-terrain",
                                             "bracket",
                                             "crossed-cylinders",
                                             "hertz-3d",
                                             "hertz-half-space",
                                             "hertz-half-space-3d",
                                             "hertz-quarter",
                                             "hertz-tetrahedra",
                                             "patch-tetrahedra",
                                             "roller",
                                             "stack-of-blocks"};
    const std::vector<std::string> syntax = {"subsection", "end", "set", "=", "#", "\\", "/", ";"};
    const std::vector<std::string> operators = {
      "table(", "if(", "(", ")", ",", "?", ":", "^", "*", "&", "|", ";", "==", "!="};
    const auto scenes = seeds_of(sources, {"prm", "tests/scenes", "tests/failures"}, ".prm");
    const auto mesh   = [&](const std::string              &name,
                          const std::string              &extension,
                          const std::vector<std::string> &words) {
      return Target{
        name, extension, stock(seeds_of(sources, meshes, extension), words), read_mesh, 2};
    };
    return {
      {"scene", ".prm", stock(scenes, syntax), read_scene, 3},
      {"check",
       ".prm",
       stock(seeds_of(sources, {"prm", "tests/scenes"}, ".prm", slow), syntax),
       check_scene,
       1},
      mesh("gmsh",
           ".msh",
           {"$Nodes",
            "$EndNodes",
            "$Elements",
            "$EndElements",
            "$PhysicalNames",
            "$Periodic",
            "$Entities",
            "$NodeData",
            "$PartitionedEntities",
            "2.2",
            "4.1",
            "4.0"}),
      mesh("abaqus",
           ".inp",
           {"*NGEN",         "*NFILL",   "*NCOPY",     "*ELGEN",
            "*ELCOPY",       "*SYSTEM",  "*NSET",      "*ELSET",
            "*SURFACE",      "*INCLUDE", ", GENERATE", "*PART, NAME=p",
            "*END PART",     "C3D10",    "C3D4",       "*INSTANCE, NAME=i, PART=p",
            "*END INSTANCE", "C3D20",    "C3D6",       "CPS3",
            "CPS8",          "U1"}),
      mesh("vtk",
           ".vtk",
           {"ASCII",
            "BINARY",
            "POINTS",
            "CELLS",
            "CELL_TYPES",
            "OFFSETS",
            "CONNECTIVITY",
            "SCALARS",
            "FIELD",
            "METADATA",
            "POLYDATA",
            "vtktypeint64",
            "double",
            "NORMALS"}),
      mesh("vtu",
           ".vtu",
           {"format=\"ascii\"",
            "format=\"binary\"",
            "format=\"appended\"",
            "offset=\"0\"",
            "header_type=\"UInt64\"",
            "compressor=\"vtkZLibDataCompressor\"",
            "<Piece>",
            "</Piece>",
            "<![CDATA[",
            "<!--",
            "&#0;",
            "&lt;",
            "Int8",
            "Float32"}),
      {"stl", ".stl", stock(seeds_of(sources, meshes, ".stl"), {"solid", "vertex"}), read_surface},
      {"deck",
       ".inp",
       stock(seeds_of(sources, meshes, ".inp"),
             {"*STEP",
              "*END STEP",
              "*STATIC",
              "*BOUNDARY",
              "*CLOAD",
              "*DLOAD",
              "*DSLOAD",
              "*AMPLITUDE, NAME=a",
              "*TRANSFORM, NSET=n",
              "*TEMPERATURE",
              "*CONTACT PAIR",
              "*FREQUENCY",
              "*MATERIAL, NAME=m",
              "*ELASTIC",
              "*EXPANSION",
              "*DENSITY",
              "OP=NEW"}),
       import,
       2},
      {"formula", ".txt", stock(paragraphs(own + "/formulas.txt"), operators), read_formula, 3},
      {"settings", ".txt", stock(paragraphs(own + "/settings.txt"), syntax), read_settings, 1}};
  }



  Scratch::Scratch(const std::string &sources)
  {
    std::string name = (fs::temp_directory_path() / "signorini-fuzz-XXXXXX").string();
    if (!mkdtemp(name.data()))
      throw std::runtime_error("no folder can be made in " + fs::temp_directory_path().string());
    root = name;
    fs::create_directories(folder());
    // Scenes name their meshes as ../meshes and ../../meshes.
    for (const std::string &place : {root + "/meshes", root + "/scenes/meshes"})
      {
        fs::create_directory(place);
        for (const char *from : {"/meshes", "/tests/meshes"})
          for (const auto &entry : fs::directory_iterator(sources + from))
            if (entry.file_size() <= largest_seed &&
                !fs::exists(place + "/" + entry.path().filename().string()))
              fs::create_symlink(entry.path(), place + "/" + entry.path().filename().string());
      }
    fs::copy_file(sources + "/tests/scenes/two-cells.prm", folder() + "/two-cells.prm");
    fs::current_path(folder());
  }



  Scratch::~Scratch()
  {
    std::error_code ignored;
    fs::current_path(fs::temp_directory_path(), ignored);
    fs::remove_all(root, ignored);
  }



  std::string
  Scratch::folder() const
  {
    return root + "/scenes/mutants";
  }



  std::vector<std::string>
  Scratch::strangers(const std::string &expected) const
  {
    const std::set<std::string> known = {"scenes",
                                         "meshes",
                                         "mutants",
                                         "two-cells.prm",
                                         expected,
                                         fs::path(expected).replace_extension(".prm").string()};
    std::vector<std::string>    result;
    for (const std::string &place : {root, root + "/scenes", folder()})
      for (const auto &entry : fs::directory_iterator(place))
        if (known.count(entry.path().filename().string()) == 0)
          {
            result.push_back(entry.path().string());
            fs::remove_all(entry.path());
          }
    return result;
  }
} // namespace Fuzz
