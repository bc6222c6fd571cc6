// SPDX-License-Identifier: Apache-2.0
// What the program prints without solving, and scenes as they are read.

#include "contact/obstacles/shapes.h"
#include "scene/documentation.h"
#include "solver/preconditioner.h"
#include <signorini/base/text.h>
#include <signorini/driver/run_scene.h>
#include <signorini/parameters/raw.h>
#include <signorini/parameters/section.h>
#include <signorini/scene/scene.h>

#include <doctest/doctest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "source_directory.h"

using namespace Signorini;

namespace
{
  std::string
  template_of(const unsigned int              dim,
              const std::vector<std::string> &words     = {},
              const std::vector<std::string> &overrides = {})
  {
    std::ostringstream out;
    print_template({dim, words, overrides}, out);
    return out.str();
  }

  bool
  has(const std::string &text, const std::string &part)
  {
    return text.find(part) != std::string::npos;
  }

  template <int dim>
  Scene<dim>
  scene_of(const std::string &text)
  {
    std::istringstream in(text);
    RawSection         raw = read_raw(in, "test.prm");
    Section            section(raw);
    Scene<dim>         scene;
    scene.declare(section);
    section.close();
    scene.read_files("");
    scene.check();
    return scene;
  }

  /// The message of the SceneError that is thrown.
  template <typename F>
  std::string
  message_of(const F &f)
  {
    try
      {
        f();
      }
    catch (const SceneError &error)
      {
        return error.what();
      }
    return "";
  }

  /// Of this process alone.
  std::string
  scratch(const std::string &name)
  {
    const auto folder =
      std::filesystem::temp_directory_path() / ("signorini-" + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
    return (folder / name).string();
  }

  const std::string block = R"(
subsection Bodies
  set Names = block
  subsection block
    set Mesh = box
    set Young's modulus = 1
    set Poisson's ratio = 0
  end
end
subsection Supports
  set Names = hold, pull
  subsection hold
    set Boundaries = block.bottom
    set Displacement = 0; 0
  end
  subsection pull
    set Boundaries = block.top
    set Displacement = 0; 0.5
  end
end
)";
} // namespace

TEST_CASE("doc/guide/reference.md is what the program says")
{
  std::ostringstream now;
  print_reference(now);
  std::ifstream      file(source_directory() + "/doc/guide/reference.md");
  std::ostringstream stored;
  stored << file.rdbuf();
  INFO("keys have changed: signorini --print-reference > doc/guide/reference.md");
  CHECK((now.str() == stored.str()));
}

TEST_CASE("the reference names all that can be chosen")
{
  std::ostringstream out;
  print_reference(out);
  const std::string page = out.str();
  for (const std::string &name : generator_names<3>())
    CHECK(has(page, "Mesh = " + name));
  for (const std::string &name : obstacle_names<3>())
    CHECK(has(page, "Shape = " + name));
  for (const std::string &name : method_names())
    CHECK(has(page, "Contact method/" + name));
  for (const std::string &name : preconditioner_names())
    CHECK(has(page, "* `" + name + "`: "));
  CHECK(has(page, "`symmetry_x`"));
  CHECK(has(page, "| `Young's modulus` | number > 0 | stress | required |"));
}

TEST_CASE("templates are scenes")
{
  CHECK(scene_of<2>(template_of(2)).bodies[0].name == "block");
  CHECK(scene_of<3>(template_of(3)).pairs[0].master == "ground");
  const std::string set =
    template_of(3, {}, {"Bodies/block/Subdivisions=3,4,5", "Contact method/Method=Nitsche"});
  CHECK(has(set, "set Subdivisions = 3,4,5"));
  CHECK(scene_of<3>(set).contact.method == "Nitsche");
  CHECK(
    has(message_of([] { template_of(2, {}, {"Bodies/block/Subdivision=3,4"}); }), "unknown key"));
}

TEST_CASE("templates of words")
{
  const std::string ring = template_of(0, {"ring"});
  CHECK(has(ring, "set Inner radius"));
  CHECK(has(ring, "set Young's modulus"));
  CHECK_FALSE(has(ring, "subsection Newton"));
  CHECK(has(template_of(0, {"shell"}), "3D"));
  const std::string several = template_of(3, {"sphere", "Nitsche", "direct", "Load steps"});
  for (const char *part : {"set Mesh = sphere",
                           "set Shape = sphere",
                           "set Method = Nitsche",
                           "subsection Nitsche",
                           "set Preconditioner = direct",
                           "subsection Load steps"})
    CHECK(has(several, part));
  CHECK_FALSE(has(several, "subsection penalty"));
  // Sections end as they begin.
  std::istringstream in(several);
  CHECK(read_raw(in, "several").sections.size() == 5);
  CHECK(has(message_of([] { template_of(2, {"rinng"}); }), "did you mean 'ring'?"));
  CHECK(has(template_of(2, {"file"}), "set Feature angle"));
}

TEST_CASE("a load may be zero, and a material must be given")
{
  const std::string load = "subsection Loads\n set Names = l\n subsection l\n"
                           "  set Boundaries = block.left\n  set Pressure = 0\n end\nend\n";
  CHECK(scene_of<2>("set Dimension = 2\n" + block + load).loads[0].pressure.is_zero());
  CHECK(has(message_of([&] {
              scene_of<2>(block + load.substr(0, load.find("  set Pressure")) + " end\nend\n");
            }),
            "Total force or Total moment is required"));
}

TEST_CASE("scene files: UTF-8 mark, directories, long lines")
{
  const std::string file = scratch("marked.prm");
  std::ofstream(file) << "\xEF\xBB\xBFset Dimension = 2\n";
  CHECK(read_raw(file).find_value("Dimension")->text == "2");
  CHECK(has(message_of([] { read_raw(scratch("")); }), "is a directory"));
  const std::string text(5000, 'x');
  CHECK(message_of([&] { scene_of<2>(text); }).size() < 400);
  CHECK(message_of([&] { scene_of<2>("set Dimension = " + text); }).size() < 800);
  CHECK(message_of([&] { scene_of<2>("set " + text + " = 2"); }).size() < 800);
}

TEST_CASE("messages have no control characters, and an end")
{
  const std::string odd = std::string("a\0b", 3) + "\x1b[2J\x7f";
  CHECK(message_of([&] { throw SceneError("'" + odd + "'\n\tis odd"); }) == "'a?b?[2J?'\n\tis odd");
  const std::string message = message_of([] { throw SceneError(std::string(60000, 'x')); });
  CHECK(has(message, "xxx... (60000 characters)"));
  CHECK(message.size() < 2000);
}

TEST_CASE("one process runs scenes one after the other")
{
  // Of several ranks each runs its own.
  const std::string file = scratch("run.prm"), folder = scratch("output");
  std::ofstream(file) << "set Dimension = 2\n" << block;
  SceneTask          task{file, {"Output/VTU=no", "Output/Directory=" + folder}, false};
  std::ostringstream out, err;
  for (unsigned int run = 0; run < 2; ++run)
    CHECK(run_scene(task, MPI_COMM_SELF, out, err) == solved);
  CHECK(err.str().empty());
  CHECK(std::filesystem::exists(folder + "/results.json"));

  task.only_check = true;
  CHECK(run_scene(task, MPI_COMM_SELF, out, err) == solved);
  CHECK(has(out.str(), "block.left: 1 faces, length 1, center (0, 0.5), (0, 0) to (0, 1)"));
  CHECK(has(out.str(), "nothing was solved"));

  task.overrides.push_back("Bodies/block/Young modulus=2");
  CHECK(run_scene(task, MPI_COMM_SELF, out, err) == bad_scene);
  CHECK(has(err.str(), "error: --set \"Bodies/block/Young modulus=2\": unknown key"));
  std::filesystem::remove_all(std::filesystem::path(file).parent_path());
}
