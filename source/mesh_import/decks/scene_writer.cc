// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/decks/scene_writer.h"

#include "mesh_import/decks/import_deck.h"
#include "mesh_import/decks/scene_text.h"
#include <signorini/parameters/raw.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <ostream>
#include <set>

namespace Signorini
{
  namespace
  {
    /// @return the 2D model that belongs to the types of the plane elements. Throws SceneError
    /// where they differ.
    std::string
    model_of_types(const DeckModel &model, const std::string &file)
    {
      static const std::vector<std::pair<std::string, std::string>> models = {
        {"CAX", "axisymmetric"}, {"CPS", "plane stress"}, {"CPE", "plane strain"}};
      std::string result, type;
      for (const auto &element : model.deck.mesh.elements)
        for (const auto &[start, name] : models)
          if (element.type.compare(0, start.size(), start) == 0)
            {
              if (!result.empty() && result != name)
                throw SceneError(
                  "'" + file + "': has elements of " + result + " (" + type + ") and of " + name +
                  " (" + element.type +
                  "); a scene has one Model for all bodies. Give all elements one of these types, or mesh "
                  "the deck in three dimensions");
              result = name;
              type   = element.type;
            }
      return result.empty() ? "plane strain" : result;
    }
  } // namespace



  // Three-dimensional if there are any solids; otherwise plane elements determine the model.
  SceneWriter::SceneWriter(DeckModel given, const std::string &file)
    : model(std::move(given))
    , file(file)
    , histories(model)
  {
    for (const auto &group : model.deck.mesh.groups)
      set_names.make_unique_name(group.name);
    bool has_solids = false, has_planes = false;
    for (const auto &element : model.deck.mesh.elements)
      {
        has_solids |= dimension_of(element.shape) == 3;
        has_planes |=
          dimension_of(element.shape) == 2 && element.type[0] == 'C' && element.type != "CONN3D2";
      }
    if (!has_solids && !has_planes)
      throw SceneError("'" + file +
                       "': no elastic solid is left: there are no elements of the "
                       "families C3D, CPE, CPS, CAX");
    dim = has_solids ? 3 : 2;
    if (dim == 2)
      kind = model_of_types(model, file);
    check_plane();
    skip_other_elements();
    make_bodies();
    is_finite_strain = switches_to_finite_strain();
  }



  /// Throws SceneError if a plane element is not parallel to the xy plane, along which supports and
  /// loads act.
  void
  SceneWriter::check_plane() const
  {
    const MeshFile &mesh = model.deck.mesh;
    if (dim == 2)
      for (const auto &element : mesh.elements)
        if (dimension_of(element.shape) == 2)
          for (const unsigned int node : element.nodes)
            if (std::abs(mesh.nodes[node][2] - mesh.nodes[element.nodes[0]][2]) >
                1e-10 * mesh.nodes[node].norm())
              throw SceneError("'" + file + "': element " + std::to_string(element.number) + " (" +
                               element.type + ") does not lie in the plane of x and y");
  }



  /// Report elements with a *SOLID SECTION that are not solids of the present dimension.
  void
  SceneWriter::skip_other_elements()
  {
    std::set<unsigned int> others;
    for (const auto &section : model.sections)
      for (const unsigned int e : section.elements)
        // The elements of distributing couplings have a section without any meaning.
        if (const auto &element = model.deck.mesh.elements[e];
            dimension_of(element.shape) < dim && element.type.compare(0, 5, "DCOUP") != 0 &&
            model.deck.removed_elements.count(e) == 0)
          others.insert(e);
    std::map<std::string, unsigned int> n;
    for (const unsigned int e : others)
      ++n[model.deck.mesh.elements[e].type];
    for (const auto &[type, count] : n)
      model.skip_item(std::to_string(count) + " elements of type " + type +
                        " (beside solids they have no stiffness)",
                      "*SOLID SECTION",
                      "body");
  }



  /// @return whether the scene uses finite strain: if the deck requests it or has a hyperelastic
  /// material, and nothing in it requires small strain.
  bool
  SceneWriter::switches_to_finite_strain()
  {
    bool is_wanted = !model.nlgeom.empty();
    for (const Body &body : all)
      {
        is_wanted |= !model.materials.at(body.material).law.empty();
        for (const MaterialOfCells &one : body.others)
          is_wanted |= !model.materials.at(one.material).law.empty();
      }
    const bool has_pressure = kind == "plane stress" && !model.pressures.empty();
    if (is_wanted && has_pressure)
      model.skip_item("*STEP, NLGEOM (strains and rotations are small, as pressures on edges of "
                      "plane stress need it)",
                      model.nlgeom);
    return is_wanted && !has_pressure;
  }



  // Load steps end at the ends of the steps of the deck, and at kinks of histories.
  std::string
  SceneWriter::steps() const
  {
    if (model.steps.empty())
      return "";
    std::set<double> times = kinks;
    for (const auto &step : model.steps)
      times.insert(step.end);
    std::vector<std::string> ends;
    for (const double t : times)
      ends.push_back(text_of_time(t));
    return "\nsubsection Load steps\n  set Times = " + join(ends) + "\nend\n";
  }



  // Decks may contain rigid-body modes that CalculiX tolerates: they are stabilised.
  std::string
  SceneWriter::unconstrained_modes() const
  {
    return std::string("\nsubsection Newton\n  # ") +
           (model.lacks_supports ?
              "Features that were not imported may have constrained bodies: check the stabilisation forces." :
              "Unconstrained rigid-body modes are stabilised, similar to CalculiX; results.json lists them.") +
           "\n  set Unconstrained modes = stabilise\nend\n";
  }



  // Characters that have a meaning in a scene file are replaced.
  std::vector<std::string>
  SceneWriter::skipped_items() const
  {
    std::vector<std::string> lines;
    for (const auto &[kind, what, places] : model.skipped_items)
      {
        std::string line = kind + ": " + what;
        if (!places[0].empty())
          line += ": " + places[0];
        if (places.size() > 1)
          line += " and " + std::to_string(places.size() - 1) + " more";
        std::replace(line.begin(), line.end(), ';', ',');
        std::replace_if(
          line.begin(), line.end(), [](const char c) { return c == '#' || c == '\\'; }, ' ');
        lines.push_back(line);
      }
    return lines;
  }



  /// Report supports that begin in a later step whose path is not linear: the program moves their
  /// nodes from their present positions to the prescribed value, the formula contains the value
  /// only.
  void
  SceneWriter::skip_paths_of_late_supports()
  {
    for (const auto &[name, begin] : late_supports)
      for (const auto &step : model.steps)
        if (const auto bend = kinks.upper_bound(step.begin);
            step.begin == begin && bend != kinks.end() && *bend < step.end)
          model.skip_item("the way of " + name +
                            " to the value of a support that begins in a later step, from where "
                            "it is; it goes there from zero",
                          "*BOUNDARY",
                          "support");
  }



  /// Remove the kinks of a step that has more than 100 of them, and report it: a load step for each
  /// would take too long.
  void
  SceneWriter::limit_steps_at_kinks()
  {
    constexpr std::size_t most = 100;
    for (const auto &step : model.steps)
      {
        const auto begin = kinks.upper_bound(step.begin), end = kinks.lower_bound(step.end);
        const auto n = std::distance(begin, end);
        if (static_cast<std::size_t>(n) <= most)
          continue;
        model.skip_item("the " + std::to_string(n) +
                          " bends of amplitudes in the step that ends at " +
                          text_of_time(step.end) + "; its end alone is solved",
                        "*AMPLITUDE",
                        "load");
        kinks.erase(begin, end);
      }
  }



  void
  SceneWriter::write(std::ostream &scene)
  {
    // All sections are written before the header, since they add to the list of omissions, and
    // loads and supports add sets to the bodies.
    std::string rigid = obstacles(); // may add equations
    rigid += equations();
    forget_reference_nodes();                           // their supports and forces are in these
    const std::string what_acts = supports() + loads(); // and makes sets of the bodies
    limit_steps_at_kinks();
    skip_paths_of_late_supports();
    const std::string body =
      bodies() + rigid + what_acts + pairs() + steps() + unconstrained_modes();
    scene << "# Made of " << file << "\nset Dimension = " << dim << "\n";
    if (dim == 2)
      scene << "set Model     = " << kind << "\n";
    if (is_finite_strain)
      scene << "set Deformation = finite\n";
    scene << "set Title     = " << std::filesystem::path(file).stem().string() << "\n";
    if (const auto lines = skipped_items(); !lines.empty())
      scene << "set Not imported = \\\n  " << join(lines, "; \\\n  ") << "\n";
    scene << body;
  }



  void
  import_deck(const std::string &file, std::ostream &out, std::ostream &messages)
  {
    SceneWriter writer(read_deck_model(file), file);
    writer.write(out);
    for (const std::string &line : writer.skipped_items())
      messages << "warning: " << file << ": not imported: " << line << "\n";
  }
} // namespace Signorini
