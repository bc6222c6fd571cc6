// SPDX-License-Identifier: Apache-2.0
// Names of keys, sections, choices and results of the last release, which are accepted for one
// more.

#include "contact/obstacles/shapes.h"
#include "scene/documentation.h"
#include "scene/former_entries.h"
#include <signorini/mesh/generator.h>
#include <signorini/parameters/section.h>
#include <signorini/scene/scene.h>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <sstream>

#include "source_directory.h"

namespace FormerNames
{
  using namespace Signorini;

  inline bool
  mentions(const std::string &text, const std::string &part)
  {
    return text.find(part) != std::string::npos;
  }

  /// A former name and the section in which it is declared; NAME stands for names of the user.
  struct Found
  {
    std::vector<std::string> path;
    FormerName               name;
  };

  inline void
  collect(const SectionDescription       &section,
          const std::vector<std::string> &path,
          std::vector<Found>             &all)
  {
    for (const FormerName &name : section.former_names)
      all.push_back({path, name});
    for (const SectionDescription &child : section.sections)
      {
        auto below = path;
        below.push_back(child.name);
        collect(child, below, all);
      }
  }

  template <typename Object>
  std::vector<Found>
  declared_in(Object &object)
  {
    SectionDescription description;
    Section            section(description);
    object.declare(section);
    std::vector<Found> all;
    collect(description, {}, all);
    return all;
  }

  /// The section at a path, in which NAME is the first one that is there.
  inline RawSection &
  section_at(RawSection &root, const std::vector<std::string> &path)
  {
    RawSection *section = &root;
    for (const std::string &name : path)
      {
        section = name == "NAME" && !section->sections.empty() ? &section->sections.front() :
                                                                 section->find_section(name);
        REQUIRE(section != nullptr);
      }
    return *section;
  }

  inline RawSection
  raw_of(const std::string &text)
  {
    std::istringstream in(text);
    return read_raw(in, "test.prm");
  }

  struct Read
  {
    std::string              text; ///< written again
    std::vector<std::string> notes;
  };

  template <typename Object>
  Read
  read_and_written(Object &object, RawSection raw)
  {
    Section section(raw);
    object.declare(section);
    section.close();
    std::ostringstream text;
    Section            out(text, false, 0, &raw);
    object.declare(out);
    return {text.str(), section.notes()};
  }

  /// Works once with each former name as with the present one, with one note; not with both.
  /// @param read reads a scene from the beginning
  template <typename F>
  void
  check_name(const Found &found, const RawSection &base, const F &read)
  {
    const auto &[kind, former, now, key] = found.name;
    INFO("former name '", former, "' of '", now, "' in ", join(found.path, "/"));
    RawSection  present = base, old = base;
    RawSection &section = section_at(old, found.path);
    if (kind == FormerName::Kind::choice)
      {
        section_at(present, found.path).set_value(key, now, "test.prm:1");
        section.set_value(key, former, "test.prm:1");
      }
    else if (kind == FormerName::Kind::key)
      {
        REQUIRE(section.find_value(now) != nullptr);
        section.find_value(now)->key = former;
      }
    else
      {
        REQUIRE(section.find_section(now) != nullptr);
        section.find_section(now)->name = former;
      }
    const Read as_present = read(present), as_former = read(old);
    CHECK(as_former.text == as_present.text);
    CHECK(as_present.notes.empty());
    REQUIRE(as_former.notes.size() == 1);
    CHECK(mentions(as_former.notes[0], former + "' is now called '"));
    CHECK(
      mentions(as_former.notes[0], now + "'; the former name is accepted until the next release"));

    // What is written has the present name.
    RawSection written = raw_of(as_former.text);
    if (kind == FormerName::Kind::key)
      CHECK(section_at(written, found.path).find_value(former) == nullptr);
    else if (kind == FormerName::Kind::section)
      CHECK(section_at(written, found.path).find_section(former) == nullptr);

    if (kind == FormerName::Kind::choice)
      return;
    RawSection both = old;
    if (kind == FormerName::Kind::key)
      section_at(both, found.path).set_value(now, section.find_value(former)->text, "test.prm:2");
    else
      section_at(both, found.path).get_section(now, "test.prm:2");
    try
      {
        read(both);
        FAIL("both names are accepted");
      }
    catch (const SceneError &error)
      {
        CHECK(mentions(error.what(), "'" + former + "' is the former name of the "));
        CHECK(mentions(error.what(), "'" + now + "', which is set at test.prm:2 too"));
      }
  }

  template <int dim>
  void
  check_all()
  {
    std::ostringstream text;
    print_template({dim, {}, {}}, text);
    const RawSection base = raw_of(text.str());
    Scene<dim>       nothing;
    const auto       names = declared_in(nothing);
    CHECK(names.size() > 20);
    for (const Found &found : names)
      check_name(found, base, [](const RawSection &raw) {
        Scene<dim> scene;
        return read_and_written(scene, raw);
      });

    RawSection file;
    file.set_value("File",
                   source_directory() + (dim == 2 ? "/meshes/blocks-2d.inp" : "/meshes/blocks.inp"),
                   "test.prm:1");
    for (const std::string &name : generator_names<dim>())
      for (const Found &found : declared_in(*MeshGenerator<dim>::create(name)))
        check_name(found, name == "file" ? file : RawSection(), [&](const RawSection &raw) {
          return read_and_written(*MeshGenerator<dim>::create(name), raw);
        });
    for (const std::string &name : obstacle_names<dim>())
      for (const Found &found : declared_in(*make_shape<dim>(name)))
        check_name(found, RawSection(), [&](const RawSection &raw) {
          return read_and_written(*make_shape<dim>(name), raw);
        });
  }

  const std::string two_pairs = R"(
set Dimension = 2
subsection Contact pairs
  set Names = one, two
  subsection one
    set Slave  = a.top
    set Master = b.bottom
    set Sides  = as named
  end
  subsection two
    set Slave  = a.left
    set Master = b.right
    set Sides  = as named
  end
end
subsection Mesh
  subsection Zones
    set Names = near
    subsection near
      set Where = x
      set Times = 2
    end
  end
end
)";

  inline Scene<2>
  scene_of_pairs(const std::vector<std::string> &overrides, std::vector<std::string> &notes)
  {
    RawSection raw = raw_of(two_pairs);
    for (const std::string &assignment : overrides)
      override_value(raw, assignment);
    Section  section(raw);
    Scene<2> scene;
    scene.declare(section);
    section.close();
    notes = section.notes();
    return scene;
  }
} // namespace FormerNames

using namespace FormerNames;



TEST_CASE("all former names of keys, sections and choices work once more")
{
  check_all<2>();
  check_all<3>();
}



TEST_CASE(
  "a former name is noted once, with the first place; the command line overrides either name")
{
  std::vector<std::string> notes;
  Scene<2>                 scene = scene_of_pairs({}, notes);
  REQUIRE(notes.size() == 4);
  CHECK(notes[0] == "test.prm:8: 'Sides' is now called 'Slave choice'; the former name is accepted "
                    "until the next release");
  CHECK(scene.pairs[1].sides == SideChoice::as_named);
  CHECK(scene.mesh.refinement_regions[0].times == 2);

  scene = scene_of_pairs({"Contact pairs/one/Slave choice=automatic",
                          "Contact pairs/two/Sides=automatic",
                          "Mesh/Refinement regions/near/Levels=3"},
                         notes);
  for (const auto &pair : scene.pairs)
    CHECK(pair.sides == SideChoice::automatic);
  CHECK(scene.mesh.refinement_regions[0].times == 3);
  CHECK(scene.mesh.refinement_regions[0].where.formula() == "x");

  scene = scene_of_pairs({"Mesh/Zones/near/Times=4"}, notes);
  CHECK(scene.mesh.refinement_regions[0].times == 4);
}



TEST_CASE("an obstacle without its Normal has the default one, with a note")
{
  for (const char *name : {"paraboloid", "punch", "cone", "gap function"})
    {
      RawSection raw;
      raw.where       = "test.prm:3";
      const auto was  = make_shape<3>(name);
      const Read read = read_and_written(*was, raw);
      REQUIRE(read.notes.size() == 1);
      CHECK(read.notes[0] == "test.prm:3: 'Normal' is not set; the default '0, 0, -1' is used");
      CHECK(mentions(read.text, "set Normal = 0, 0, -1"));
    }
}



TEST_CASE("results have former names beside the present ones, and expected results may use them")
{
  CHECK(present_path("definite", 2) == "tangent_positive_definite");
  CHECK(present_path("load_steps/0/definite", 2) == "load_steps/0/tangent_positive_definite");
  CHECK(present_path("held_motions/largest_force", 3) == "stabilised_modes/largest_force");
  CHECK(present_path("accuracy/quantities/force of foot/bar", 3) ==
        "accuracy/quantities/force of foot/error_bound");
  CHECK(present_path("linear_reference/R", 2) == "linear_reference/time_ratio");
  CHECK(present_path("pairs/left_out/force/1", 2) == "pairs/left_out/force/1");
  CHECK(present_path("probes/tip/stress/2", 2) == "probes/tip/stress/xy");
  CHECK(present_path("probes/tip/stress/3", 2) == "probes/tip/stress/zz");
  CHECK(present_path("probes/tip/stress/5", 3) == "probes/tip/stress/yz");
  CHECK(present_path("probes/tip/stress/xx", 3) == "probes/tip/stress/xx");

  nlohmann::ordered_json results = {{"skipped", {"pair far"}},
                                    {"load_steps",
                                     {{{"snap_through_ratio", 0}}, {{"snap_through_ratio", 5}}}}};
  add_former_entries(results);
  CHECK(results["left_out"] == results["skipped"]);
  CHECK(results["load_steps"][1]["jump"] == 5);
  CHECK(results["deprecated"]["entries"]["load_steps/*/jump"] == "load_steps/*/snap_through_ratio");
  CHECK(results["deprecated"]["checks"]["acts"] == "inactive pair");
}
