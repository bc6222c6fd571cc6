// SPDX-License-Identifier: Apache-2.0
#include "scene/decisions.h"
#include "scene/descriptions.h"
#include "scene/skipped_items.h"
#include <signorini/base/scene_error.h>
#include <signorini/base/text.h>
#include <signorini/parameters/section.h>
#include <signorini/scene/scene.h>

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  void
  MaterialOfCells::declare(Section &section)
  {
    section.add_required("Cells", cells, "name of the cell set in the mesh file");
    material.declare(section);
    section.add("Thermal expansion",
                expansion,
                "alpha, one number, or three along x, y, z; empty: that of the body, whose "
                "temperature it is [1/temperature]");
    place = section.source_of("Cells");
    if (section.reading() && expansion.size() != 0 && expansion.size() != 1 &&
        expansion.size() != 3)
      section.fail("Thermal expansion", "needs one number, or three along x, y, z");
  }



  // Sets of cells with materials are passed to the mesh, which assigns material ids.
  template <int dim>
  void
  Body<dim>::declare(Section &section)
  {
    mesh.declare(section);
    section.add("Degree",
                degree,
                "polynomial degree of the displacement of this body; 0: Mesh/Degree",
                Range{0, 2});
    material.declare(section);
    expansion.declare(section, mesh.generator->has_temperature());
    section.add_named(
      "Materials",
      others,
      "Materials of cell sets of a Mesh = file, instead of the material of the body.");
    mesh.cells_of_materials.clear();
    for (const MaterialOfCells &one : others)
      {
        if (!one.expansion.empty() && !expansion.given())
          section.fail(
            "Thermal expansion",
            "is required, because one of the Materials sets it; set 0 if the rest of the body "
            "does not expand");
        mesh.cells_of_materials.push_back(one.cells);
      }
  }



  template <int dim>
  void
  Body<dim>::check() const
  {
    const std::vector<std::string> sets = mesh.generator->cell_sets();
    for (const MaterialOfCells &one : others)
      if (std::find(sets.begin(), sets.end(), one.cells) == sets.end())
        throw SceneError(one.place +
                         ": the mesh has no cell set of that name; it has: " + join(sets));
  }



  template <int dim>
  std::vector<const Material *>
  Body<dim>::materials() const
  {
    std::vector<const Material *> result{&material};
    for (const MaterialOfCells &one : others)
      result.push_back(&one.material);
    return result;
  }



  namespace
  {
    /// Declare the section of expected results.
    void
    declare_expected(Section                     &section,
                     std::vector<ExpectedResult> &expected,
                     const unsigned int           dim)
    {
      section.add_named("Expected results",
                        expected,
                        "Reference values that the results are compared with.");
      if (section.reading())
        for (ExpectedResult &one : expected)
          one.use_present_paths(section, dim);
    }

    /// Tell a method what it makes laws for: contact points of one or of all components.
    template <int dim>
    void
    tell(ContactMethod &method, const std::vector<ContactPair<dim>> &pairs)
    {
      method.has_friction = std::any_of(pairs.begin(), pairs.end(), [](const auto &pair) {
        return !pair.friction.is_zero();
      });
      method.has_ties =
        std::any_of(pairs.begin(), pairs.end(), [](const auto &pair) { return pair.is_tied; });
      method.has_strength  = std::any_of(pairs.begin(), pairs.end(), [](const auto &pair) {
        return pair.strength.given();
      });
      method.has_late_ties = std::any_of(pairs.begin(), pairs.end(), [](const auto &pair) {
        return pair.is_tied && pair.from > 0;
      });
    }
  } // namespace



  // In the order of the data: later sections may refer to names of earlier ones. The same function
  // reads a scene, writes it with defaults, and describes the keys.
  template <int dim>
  void
  Scene<dim>::declare(Section &section)
  {
    unsigned int dimension = dim;
    section.add("Dimension", dimension, "2 | 3");
    section.add_choice(
      "Model",
      model,
      model_names<dim>(),
      dim == 2 ? "axisymmetric: x is the radius, y the axis, and forces are those of the whole "
                 "circumference; else forces are per thickness" :
                 "three-dimensional solid");
    section.add_choice(
      "Deformation",
      deformation,
      {{"small", Deformation::small},
       {"finite", Deformation::finite},
       {"automatic", Deformation::automatic}},
      "small: small strains and rotations; finite: finite strain with the Law of each body, and contact in the current "
      "configuration (large sliding); automatic: small, and finite as soon as the work error of a small-strain solution "
      "exceeds the Finite-strain tolerance");
    section.rename_key("Deformation share", "Finite-strain tolerance");
    section.add(
      "Finite-strain tolerance",
      deformation_share,
      "relative work error of the small-strain solution above which Deformation = automatic changes to finite; "
      "a smaller Accuracy/Target error takes precedence",
      Range{0, 1, false});
    section.add("Title", title, "");
    section.rename_key("Left out", "Not imported");
    section.add(
      "Not imported",
      skipped_items,
      "features of an imported deck that are not supported, separated by ;   each KIND: what, where. They are printed; "
      "the verdict warns if a load, support, motion, pair, body or material is missing, and fails if nothing is loaded "
      "without it");
    if (section.reading())
      skipped_in(skipped_items);

    // Definitions come before everything that contains formulas.
    section.add_definitions("Definitions",
                            definitions,
                            "Names that stand for numbers or formulas, in all that follows: "
                            "set R = 8, set r = sqrt(x^2+y^2), set gap = r^2/(2*R)");
    section.add_named("Bodies", bodies, "Elastic bodies: a mesh and a material each.");
    section.add_named("Obstacles", obstacles, "Rigid surfaces; they are never meshed.");
    section.add_named("Supports", supports, "Prescribed displacements.");
    section.add_named("Constraint equations",
                      equations,
                      "Linear equations between displacements of nodes.");
    section.add_named("Loads", loads, "Tractions, pressures, body forces.");
    section.add_named("Contact pairs",
                      pairs,
                      "Surfaces that may touch. Names = auto finds facing surfaces.");
    // Either each contact pair has slave and master, or the only name is `auto` without them.
    auto_pairs = pairs.size() == 1 && pairs[0].name == "auto" && pairs[0].slave.empty() &&
                 pairs[0].master.empty();
    if (section.reading() && !auto_pairs)
      for (const ContactPair<dim> &pair : pairs)
        if (pair.slave.empty() || pair.master.empty())
          throw SceneError(
            "Contact pairs/" + pair.name +
            ": Slave and Master are required; to find all pairs automatically, set Contact pairs/Names = auto as the only name");
    section.add_section(
      "Mesh",
      "Refinement, partitioning and polynomial degree of the meshes of all bodies.",
      [&](Section &s) {
        mesh.declare(s);
        s.add(
          "Degree",
          degree,
          "polynomial degree of the displacement of bodies without a Degree of their own; 0: that of the elements of "
          "triangles and tetrahedra that are kept; otherwise degree 1, or degree 2 for bodies for which that is cheaper for "
          "the Accuracy/Target error",
          Range{0, 2});
      });
    section.add_section(
      "Contact method",
      "Method chooses the contact method; the sections of the other methods are ignored.",
      [&](Section &s) { contact.declare(s); });
    for (auto &[name, method] : contact.methods)
      tell(*method, pairs);
    section.add_section("Accuracy",
                        "Quantities of interest, their error bounds, and adaptive refinement.",
                        [&](Section &s) {
                          goals.declare(s);
                          refinement.declare(s);
                        });
    section.add_section("Load steps", "Load history.", [&](Section &s) { load_steps.declare(s); });
    section.add_section("Newton", "Nonlinear solver.", [&](Section &s) { newton.declare(s); });
    section.add_section("Solver", "Linear solver.", [&](Section &s) { solver.declare(s); });
    section.add_section("Output", "Files that are written.", [&](Section &s) {
      output.declare(s);
    });
    if (section.reading())
      end_steps_at_changes();
    section.add_section(
      "Known solution",
      "Exact solution, as formulas; the errors of the computed solution are reported.",
      [&](Section &s) { known.declare(s); });
    declare_expected(section, expected, dim);
  }



  // Times at which supports and pairs begin or cease become ends of load steps, in increasing
  // order.
  template <int dim>
  void
  Scene<dim>::end_steps_at_changes()
  {
    load_steps.changes.clear();
    const auto add = [&](const TimeSpan &span, const std::string &entry) {
      // Further load steps may follow a run whose checkpoint is kept.
      if (span.from >= load_steps.end_time && !output.keep_checkpoint)
        throw SceneError(entry + "/Start time = " + short_text(span.from) +
                         ": the load history ends at t = " + short_text(load_steps.end_time) +
                         ", so that this is never active; set an earlier time, or remove it");
      for (const double t : {span.from, span.until})
        if (t > 0)
          load_steps.changes.push_back(t);
    };
    for (const Support<dim> &support : supports)
      add(support, "Supports/" + support.name);
    for (const ContactPair<dim> &pair : named_pairs())
      {
        add(pair, "Contact pairs/" + pair.name);
        add(pair.pretension.driven, "");
      }
    for (const Obstacle<dim> &obstacle : obstacles)
      add(obstacle.body.driven, "");
    std::sort(load_steps.changes.begin(), load_steps.changes.end());
  }



  // Messages of files that several bodies use are reported once.
  template <int dim>
  void
  Scene<dim>::read_files(const std::string &folder)
  {
    const auto add = [&](const std::vector<std::string> &more) {
      for (const std::string &note : more) // several bodies may share a file
        if (std::find(notes.begin(), notes.end(), note) == notes.end())
          notes.push_back(note);
    };
    for (Body<dim> &body : bodies)
      add(body.mesh.generator->read_file(folder, Decisions<dim>::needs_hypercubes(*this, body)));
    add(bodies_that_come_apart());
    for (Obstacle<dim> &obstacle : obstacles)
      obstacle.shape->read_file(folder);
  }



  // Bodies do not share nodes, also where the parts of the file do.
  template <int dim>
  std::vector<std::string>
  Scene<dim>::bodies_that_come_apart() const
  {
    std::vector<std::string> result;
    const auto               is_of = [](const std::string &boundary, const Body<dim> &body) {
      return boundary.compare(0, body.name.size() + 1, body.name + ".") == 0;
    };
    for (unsigned int i = 0; i < bodies.size(); ++i)
      for (unsigned int j = 0; j < i && !auto_pairs; ++j)
        {
          const Body<dim> &a = bodies[i], &b = bodies[j];
          const auto       beside = a.mesh.generator->neighbours();
          const bool       joined = std::any_of(pairs.begin(), pairs.end(), [&](const auto &pair) {
            return (is_of(pair.slave, a) && is_of(pair.master, b)) ||
                   (is_of(pair.slave, b) && is_of(pair.master, a));
          });
          if (!joined && std::count(beside.begin(), beside.end(), b.mesh.generator->origin()) > 0)
            result.push_back("the bodies " + b.name + " and " + a.name +
                             " have common faces in their file, but no contact pair joins them, so "
                             "that they come apart; Law = tied holds them together");
        }
    return result;
  }



  template <int dim>
  unsigned int
  Scene<dim>::maximum_cycles() const
  {
    constexpr unsigned int most = 40; // cells are too many before, or too small
    return goals.has_targets() && refinement.cycles == 0 ? most : refinement.cycles;
  }



  // The master of a pair is either a boundary or the name of an obstacle.
  template <int dim>
  const Obstacle<dim> *
  Scene<dim>::obstacle_of(const ContactPair<dim> &pair) const
  {
    for (const Obstacle<dim> &obstacle : obstacles)
      if (obstacle.name == pair.master)
        return &obstacle;
    return nullptr;
  }



  template struct Body<2>;
  template struct Body<3>;
  template struct Scene<2>;
  template struct Scene<3>;
} // namespace Signorini
