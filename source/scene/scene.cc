#include <signorini/elasticity/material_law.h>
#include <signorini/parameters/section.h>
#include <signorini/parameters/text.h>
#include <signorini/scene/descriptions.h>
#include <signorini/scene/formulation.h>
#include <signorini/scene/left_out.h>
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
    place = section.place_of("Cells");
    if (section.reading() && expansion.size() != 0 && expansion.size() != 1 &&
        expansion.size() != 3)
      section.fail("Thermal expansion", "needs one number, or three along x, y, z");
  }



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
    expansion.declare(section, !mesh.generator->temperature().empty());
    section.add_named(
      "Materials",
      others,
      "Materials of cell sets of a Mesh = file, instead of the material of the body.");
    mesh.cells_of_materials.clear();
    for (const MaterialOfCells &one : others)
      {
        const std::vector<std::string> sets = mesh.generator->cell_sets();
        if (section.reading() && std::find(sets.begin(), sets.end(), one.cells) == sets.end())
          throw SceneError(one.place +
                           ": the mesh has no cell set of that name; it has: " + join(sets));
        if (!one.expansion.empty() && !expansion.given())
          section.fail(
            "Thermal expansion",
            "is required, because one of the Materials sets it; set 0 if the rest of the body "
            "does not expand");
        mesh.cells_of_materials.push_back(one.cells);
      }
  }



  template <int dim>
  std::vector<Material *>
  Body<dim>::materials()
  {
    std::vector<Material *> result{&material};
    for (MaterialOfCells &one : others)
      result.push_back(&one.material);
    return result;
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
  } // namespace



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
      left_out,
      "features of an imported deck that are not supported, separated by ;   each KIND: what, where. They are printed; "
      "the verdict warns if a load, support, motion, pair, body or material is missing, and fails if nothing is loaded "
      "without it");
    if (section.reading())
      left_out_of(left_out);

    section.add_definitions("Definitions",
                            definitions,
                            "Names that stand for numbers or formulas, in all that follows: "
                            "set R = 8, set r = sqrt(x^2+y^2), set gap = r^2/(2*R)");
    section.add_named("Bodies", bodies, "Elastic bodies: a mesh and a material each.");
    section.add_named("Obstacles", obstacles, "Rigid surfaces; they are never meshed.");
    section.add_named("Supports", supports, "Prescribed displacements.");
    section.add_named("Loads", loads, "Tractions, pressures, body forces.");
    section.add_named("Contact pairs",
                      pairs,
                      "Surfaces that may touch. Names = auto finds facing surfaces.");
    auto_pairs = pairs.size() == 1 && pairs[0].name == "auto" && pairs[0].slave.empty() &&
                 pairs[0].master.empty();
    if (section.reading() && !auto_pairs)
      for (const ContactPair<dim> &pair : pairs)
        if (pair.slave.empty() || pair.master.empty())
          throw SceneError(
            "Contact pairs/" + pair.name +
            ": Slave and Master are required; to find all pairs automatically, set Contact pairs/Names = auto as the only name");
    bool has_degree = false;
    section.add_section(
      "Mesh",
      "Refinement, partitioning and polynomial degree of the meshes of all bodies.",
      [&](Section &s) {
        mesh.declare(s);
        has_degree = s.reading() && s.is_set("Degree");
        s.add(
          "Degree",
          degree,
          "polynomial degree of the displacement of bodies without a Degree of their own; 0: degree 1, and degree 2 for "
          "those for which that is cheaper for the Accuracy/Target error",
          Range{0, 2});
      });
    section.add_section(
      "Contact method",
      "Method chooses the contact method; the sections of the other methods are ignored.",
      [&](Section &s) { contact.declare(s); });
    section.add_section("Accuracy",
                        "Quantities of interest, their error bounds, and adaptive refinement.",
                        [&](Section &s) {
                          goals.declare(s);
                          refinement.declare(s);
                        });
    if (section.reading() && contact.is_automatic)
      choose(has_degree);
    if (section.reading())
      choose_formulations(*this, has_degree);
    if (section.reading() && deformation == Deformation::finite)
      become_finite();
    section.add_section("Load steps", "Load history.", [&](Section &s) { load_steps.declare(s); });
    if (section.reading())
      end_steps_where_supports_change();
    section.add_section("Newton", "Nonlinear solver.", [&](Section &s) { newton.declare(s); });
    section.add_section("Solver", "Linear solver.", [&](Section &s) { solver.declare(s); });
    section.add_section("Output", "Files that are written.", [&](Section &s) {
      output.declare(s);
    });
    section.add_section(
      "Known solution",
      "Exact solution, as formulas; the errors of the computed solution are reported.",
      [&](Section &s) { known.declare(s); });
    declare_expected(section, expected, dim);
  }



  template <int dim>
  void
  Scene<dim>::end_steps_where_supports_change()
  {
    load_steps.changes.clear();
    for (const Support<dim> &support : supports)
      {
        if (support.from >= load_steps.end_time)
          throw SceneError("Supports/" + support.name +
                           "/Start time = " + short_text(support.from) +
                           ": the load history ends at t = " + short_text(load_steps.end_time) +
                           ", so that this support is never active; set an earlier time, or remove "
                           "the support");
        for (const double t : {support.from, support.until})
          if (t > 0)
            load_steps.changes.push_back(t);
      }
    std::sort(load_steps.changes.begin(), load_steps.changes.end());
  }



  template <int dim>
  void
  Scene<dim>::become_finite()
  {
    deformation = Deformation::finite;
    for (Body<dim> &body : bodies)
      for (Material *material : body.materials())
        material->constitutive_law = law_of(*material).make(*material);
  }



  // By the curves of doc/accuracy.md: with multipliers nothing is left to choose and nothing
  // overlaps, at the price of the others.
  template <int dim>
  void
  Scene<dim>::choose(const bool has_degree)
  {
    choice = contact.method + ", which has no parameter and no penetration";
    if (has_degree)
      return;
    degree = 0;
    choice += goals.has_targets() ?
                "; degree 1, or degree 2 for bodies whose errors are far above the target" :
                "; degree 1, since there is no Target error";
  }



  template <int dim>
  unsigned int
  Scene<dim>::most_cycles() const
  {
    constexpr unsigned int most = 40; // cells are too many before, or too small
    return goals.has_targets() && refinement.cycles == 0 ? most : refinement.cycles;
  }



  template <int dim>
  std::vector<QuantityName>
  Scene<dim>::quantities() const
  {
    QuantityNames names{names_of(pairs), names_of(supports), {}, {}, {}};
    for (const Probe<dim> &probe : output.probes)
      if (!probe.is_line())
        (probe.is_on_pair() ? names.surface_probes : names.probes).push_back(probe.name);
    for (const Obstacle<dim> &obstacle : obstacles)
      if (obstacle.body.can_move())
        names.obstacles.push_back(obstacle.name);
    std::vector<QuantityName> result;
    for (const std::string &text : goals.quantities)
      result.push_back(read_quantity(text, "Accuracy/Quantity", names, dim));
    return result;
  }



  template <int dim>
  std::vector<unsigned int>
  Scene<dim>::degrees() const
  {
    std::vector<unsigned int> result;
    for (const Body<dim> &body : bodies)
      result.push_back(body.degree > 0 ? body.degree : std::max(degree, 1u));
    return result;
  }



  template <int dim>
  std::vector<bool>
  Scene<dim>::open_degrees() const
  {
    std::vector<bool> result;
    for (const Body<dim> &body : bodies)
      result.push_back(goals.has_targets() && degree + body.degree == 0);
    return result;
  }



  template <int dim>
  unsigned int
  Scene<dim>::degree_of(const std::string &surface) const
  {
    const auto dot = surface.find('.');
    for (const Body<dim> &body : bodies)
      if (dot != std::string::npos && body.name == surface.substr(0, dot))
        return body.degree > 0 ? body.degree : std::max(degree, 1u);
    return 0;
  }



  template <int dim>
  Integration
  Scene<dim>::integration_of(const ContactPair<dim> &pair) const
  {
    const unsigned int slave = degree_of(pair.slave), master = degree_of(pair.master);
    // Without bias each is the slave once.
    const unsigned int largest = std::max(slave, master);
    return contact.chosen().unbiased() ? contact.integration_of_degrees(largest, largest) :
                                         contact.integration_of_degrees(slave, master);
  }



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
