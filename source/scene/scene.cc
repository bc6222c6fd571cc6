#include <signorini/elasticity/material_law.h>
#include <signorini/parameters/section.h>
#include <signorini/scene/descriptions.h>
#include <signorini/scene/formulation.h>
#include <signorini/scene/scene.h>

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

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
  }



  ContactSettings::ContactSettings()
  {
    for (const std::string &name : method_names())
      methods.emplace_back(name, ContactMethod::create(name));
  }



  const ContactMethod &
  ContactSettings::chosen() const
  {
    return *std::find_if(methods.begin(), methods.end(), [&](const auto &m) {
              return m.first == method;
            })->second;
  }



  void
  ContactSettings::stiffen(const double factor)
  {
    for (const auto &[name, one] : methods)
      if (name == method)
        one->stiffen(factor);
  }



  void
  ContactSettings::declare(Section &section)
  {
    std::vector<std::string> choices = method_names();
    choices.emplace_back("auto");
    section.add_choice(
      "Method",
      method,
      choices,
      "how contact is imposed; auto: what costs least for the Target error, and the "
      "degree of bodies, if nobody sets it");
    if (method == choices.back())
      {
        is_automatic = true;
        method       = ContactSettings().method;
      }
    section.add_choice(
      "Integration",
      integration,
      or_auto(Integration::rules()),
      "of slave faces: auto: what suits the method; segments: exactly, on their intersections with master faces; by Gauss "
      "points on whole faces (cheaper); at the nodes (cheapest)");
    section.add(
      "Quadrature points",
      quadrature_points,
      "a direction on a segment or face; 0: degree + 1; degree + 3 for weighted methods on whole faces, and on segments of "
      "faces far from parallelograms, as those of divided tetrahedra; nodes have degree + 1",
      Range{0, 20});
    section.add_choice(
      "Pressure basis",
      pressure_basis,
      {{"dual", Basis::dual}, {"standard", Basis::standard}},
      "of methods that weigh the gap at slave nodes: functions biorthogonal to the displacement's (fewest Newton steps), "
      "or the displacement's own");
    section.add_choice(
      "Contact geometry",
      geometry,
      {{"automatic", ContactGeometry::automatic},
       {"reference", ContactGeometry::reference},
       {"updated", ContactGeometry::updated}},
      "where gaps and normals are taken: reference: of the surfaces at rest; updated: of the surfaces as they are now, "
      "which costs a search and a solve or two more; automatic: as they are now where that changes the pressure");
    section.add(
      "Geometry share",
      geometry_share,
      "of the pressure that automatic does not update for; it is estimated from the solution",
      Range{0, 1, false});
    for (const auto &[name, object] : methods)
      section.add_section(name, about_method(name), [&, object = object](Section &s) {
        object->declare(s);
      });
  }



  Integration
  ContactSettings::integration_of_degrees(const unsigned int slave, const unsigned int master) const
  {
    const Rule rule   = integration.value_or(chosen().usual_integration());
    const bool weighs = chosen().sampling() == Sampling::nodes;
    // Nodes are those of the slave, and forces at points push its nodes: it has to follow them all.
    const bool         of_slave = rule == Rule::nodes || (rule == Rule::quadrature && !weighs);
    const unsigned int degree   = of_slave ? slave : std::max(slave, master);
    const unsigned int usual    = rule == Rule::quadrature && weighs ? degree + 3 : degree + 1;
    return {rule,
            quadrature_points == 0 || rule == Rule::nodes ? usual : quadrature_points,
            weighs ? pressure_basis : Basis::standard,
            quadrature_points == 0 ? degree + 3 : quadrature_points};
  }



  void
  LoadSteps::declare(Section &section)
  {
    section.add("End time",
                end_time,
                "t runs from 0 to this; supports, loads and obstacles depend on it",
                positive);
    section.add("Number", number, "of equal steps", Range{1, 1e6});
    section.add("Times", times, "ends of the steps, instead of End time and Number; increasing");
    section.add("Cut-backs",
                cut_backs,
                "how often a step that cannot be solved is halved; it grows again afterwards",
                Range{0, 20});
    for (unsigned int i = 0; i < times.size(); ++i)
      if (times[i] <= (i > 0 ? times[i - 1] : 0))
        section.fail("Times", "must be positive and increasing");
    if (section.reading() && !times.empty())
      {
        end_time = times.back();
        number   = times.size();
      }
  }



  std::vector<double>
  LoadSteps::ends() const
  {
    if (!times.empty())
      return times;
    std::vector<double> result;
    for (unsigned int step = 1; step <= number; ++step)
      result.push_back(end_time * step / number);
    return result;
  }



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
                 "what the mesh stands for");
    section.add_choice(
      "Deformation",
      deformation,
      {{"small", Deformation::small}, {"finite", Deformation::finite}},
      "of bodies: strains and rotations are small beside one; or of any amount, with the Law of each body, "
      "and contact on the surfaces as they are now");
    section.add("Title", title, "");

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
                      "Surfaces that may touch. Names = auto finds those that see each other.");
    auto_pairs = pairs.size() == 1 && pairs[0].name == "auto" && pairs[0].slave.empty() &&
                 pairs[0].master.empty();
    if (section.reading() && !auto_pairs)
      for (const ContactPair<dim> &pair : pairs)
        if (pair.slave.empty() || pair.master.empty())
          throw SceneError(
            "Contact pairs/" + pair.name +
            ": a pair needs a Slave and a Master; Names = auto stands alone, and finds both");
    bool has_degree = false;
    section.add_section(
      "Mesh",
      "What is done to the meshes of all bodies before the first solution.",
      [&](Section &s) {
        mesh.declare(s);
        has_degree = s.reading() && s.is_set("Degree");
        s.add(
          "Degree",
          degree,
          "polynomial degree of the displacement, of bodies that do not set theirs; 0: 1, and 2 for those for which "
          "an Accuracy/Target error makes that pay",
          Range{0, 2});
      });
    section.add_section("Contact method",
                        "One line switches the method; the others' sections are ignored.",
                        [&](Section &s) { contact.declare(s); });
    section.add_section("Accuracy",
                        "What is wanted, how accurately, and adaptive refinement for it.",
                        [&](Section &s) {
                          goals.declare(s);
                          refinement.declare(s);
                        });
    if (section.reading() && contact.is_automatic)
      choose(has_degree);
    if (section.reading())
      choose_formulations(*this, has_degree);
    if (section.reading() && deformation == Deformation::finite)
      for (Body<dim> &body : bodies)
        body.material.energy = law_of(body.material).make(body.material);
    section.add_section("Load steps", "The history of loading.", [&](Section &s) {
      load_steps.declare(s);
    });
    section.add_section("Newton", "The nonlinear iteration.", [&](Section &s) {
      newton.declare(s);
    });
    section.add_section("Solver", "The linear systems.", [&](Section &s) { solver.declare(s); });
    section.add_section("Output", "What is written.", [&](Section &s) { output.declare(s); });
    section.add_section("Known solution",
                        "Formulas that the computed solution is compared with.",
                        [&](Section &s) { known.declare(s); });
    section.add_named("Expected results", expected, "What is known about the answer.");
  }



  // By the curves of doc/accuracy.md: with multipliers nothing is left to choose and nothing
  // overlaps, at the price of the others.
  template <int dim>
  void
  Scene<dim>::choose(const bool has_degree)
  {
    choice = contact.method + ", which needs no parameter and leaves no gap";
    if (has_degree)
      return;
    degree = 0;
    choice += goals.has_targets() ? "; degree 1, or 2 where bodies are far from the target" :
                                    "; degree 1, since there is no Target error";
  }



  namespace
  {
    template <int dim>
    std::vector<std::string>
    boundary_names(const std::vector<Body<dim>> &bodies)
    {
      std::vector<std::string> names;
      for (const Body<dim> &body : bodies)
        for (const std::string &boundary : body.mesh.generator->boundaries())
          names.push_back(body.name + "." + boundary);
      return names;
    }

    template <int dim>
    std::vector<std::string>
    node_set_names(const std::vector<Body<dim>> &bodies)
    {
      std::vector<std::string> names;
      for (const Body<dim> &body : bodies)
        for (const std::string &set : body.mesh.generator->node_sets())
          names.push_back(body.name + "." + set);
      return names;
    }

    /// BODY.NUMBER of a node of a mesh file.
    template <int dim>
    bool
    is_node_number(const std::vector<Body<dim>> &bodies, const std::string &name)
    {
      for (const Body<dim> &body : bodies)
        if (const std::string start = body.name + "."; name.compare(0, start.size(), start) == 0)
          return !body.mesh.generator->node_set(name.substr(start.size())).empty();
      return false;
    }

    template <typename Items>
    std::vector<std::string>
    names_of(const Items &items)
    {
      std::vector<std::string> names;
      for (const auto &item : items)
        names.push_back(item.name);
      return names;
    }

    /// In one matrix, rounding of the stiff body is a force on the soft one.
    template <int dim>
    void
    check_contrast(const std::vector<Body<dim>> &bodies)
    {
      constexpr double largest   = 1e8;
      const auto       is_softer = [](const Body<dim> &a, const Body<dim> &b) {
        return a.material.youngs_modulus < b.material.youngs_modulus;
      };
      const auto [soft, stiff] = std::minmax_element(bodies.begin(), bodies.end(), is_softer);
      if (stiff->material.youngs_modulus > largest * soft->material.youngs_modulus)
        throw SceneError("Bodies/" + stiff->name +
                         "/Young's modulus: more than 1e8 times that of '" + soft->name +
                         "', beyond what rounding allows; take an obstacle for a rigid body");
    }

    /// What keeps the symmetry about the axis: motions and forces along it.
    template <int dim>
    void
    check_axisymmetric(const Scene<dim> &scene)
    {
      if (model_of(scene.model) != Model::axisymmetric)
        return;
      for (const Obstacle<dim> &obstacle : scene.obstacles)
        {
          const RigidBody<dim> &body = obstacle.body;
          const bool            sideways =
            body.displacement.given() && (body.is_free(0) || !body.displacement.is_zero(0));
          if (sideways || body.rotation.given())
            throw SceneError("Obstacles/" + obstacle.name +
                             ": with Model = axisymmetric an obstacle moves along the axis only; "
                             "write Displacement = 0; ... and no Rotation");
        }
    }

    /// What a generator made of pieces that touch must have, if it was not told what they are.
    template <int dim>
    void
    check_pieces(const Scene<dim> &scene)
    {
      for (const Body<dim> &body : scene.bodies)
        {
          const std::string reason = body.mesh.generator->needs_pair(), start = body.name + ".";
          bool              joined = false;
          for (const ContactPair<dim> &pair : scene.known_pairs())
            joined |= pair.slave.compare(0, start.size(), start) == 0 &&
                      pair.master.compare(0, start.size(), start) == 0;
          if (!reason.empty() && !joined)
            throw SceneError(reason);
        }
    }

    /// Twice the same conditions would not say how pressure is shared.
    template <int dim>
    void
    check_same_pairs(const std::vector<ContactPair<dim>> &pairs)
    {
      for (unsigned int i = 0; i < pairs.size(); ++i)
        for (unsigned int j = 0; j < i; ++j)
          if ((pairs[i].slave == pairs[j].slave && pairs[i].master == pairs[j].master) ||
              (pairs[i].slave == pairs[j].master && pairs[i].master == pairs[j].slave))
            throw SceneError(pairs[i].slave_place + ": pairs '" + pairs[j].name + "' and '" +
                             pairs[i].name + "' are of the same surfaces; remove one");
    }

    void
    require(const std::string              &what,
            const std::vector<std::string> &wanted,
            const std::vector<std::string> &existing,
            const std::string              &place,
            const std::vector<std::string> &node_sets = {})
    {
      for (const std::string &name : wanted)
        if (std::find(existing.begin(), existing.end(), name) == existing.end())
          {
            const std::string close = nearest(name, existing);
            if (what == "boundary" &&
                std::find(node_sets.begin(), node_sets.end(), name) != node_sets.end())
              throw SceneError(place + ": '" + name +
                               "' is a set of nodes without all corners of any face; supports and "
                               "loads take it by the key Nodes");
            throw SceneError(place + ": there is no " + what + " '" + name + "'" +
                             (close.empty() ? "." : "; did you mean '" + close + "'?") +
                             " There are: " + join(existing) + ".");
          }
    }
  } // namespace



  template <int dim>
  void
  Scene<dim>::check() const
  {
    if (bodies.empty())
      throw SceneError("Bodies/Names: a scene needs at least one body");
    const auto body_names     = names_of(bodies);
    const auto obstacle_names = names_of(obstacles);
    const auto boundaries     = boundary_names(bodies);
    const auto sets           = node_set_names(bodies);
    const auto require_nodes  = [&](const NodeChoice &nodes) {
      std::vector<std::string> named; // the others are numbers of nodes
      for (const std::string &set : nodes.sets)
        if (!is_node_number(bodies, set))
          named.push_back(set);
      require("set of nodes", named, sets, nodes.sets_place);
      if (!nodes.body.empty())
        require("body", {nodes.body}, body_names, nodes.point_place);
    };
    for (const Support<dim> &support : supports)
      {
        require("boundary", support.boundaries, boundaries, support.place, sets);
        require_nodes(support.nodes);
      }
    for (const Load<dim> &load : loads)
      {
        require("boundary", load.boundaries, boundaries, load.place, sets);
        require_nodes(load.nodes);
        require("body", load.bodies, body_names, load.bodies_place);
      }
    std::vector<std::string> masters = boundaries;
    masters.insert(masters.end(), obstacle_names.begin(), obstacle_names.end());
    for (const ContactPair<dim> &pair : known_pairs())
      {
        require("boundary", {pair.slave}, boundaries, pair.slave_place, sets);
        require("boundary or obstacle", {pair.master}, masters, pair.master_place, sets);
        if (pair.slave == pair.master)
          throw SceneError(pair.master_place +
                           ": a surface cannot touch itself; name another surface or an obstacle");
        if (obstacle_of(pair) && std::count(boundaries.begin(), boundaries.end(), pair.master))
          throw SceneError(pair.master_place +
                           ": is the name of a boundary and of an obstacle; rename the obstacle");
      }
    check_same_pairs(known_pairs());
    for (const RefinementZone<dim> &zone : mesh.zones)
      require("body", zone.bodies, body_names, zone.place);
    check_pieces(*this);
    check_axisymmetric(*this);
    check_integration();
    check_contrast(bodies);
    if (deformation == Deformation::finite)
      check_finite();
    if (!auto_pairs)
      quantities();
    if (mesh.distribution == Distribution::METIS && most_cycles() > 0)
      throw SceneError("Mesh/Distribution = METIS has a fixed mesh, but " +
                       (goals.has_targets() ?
                          "there is an Accuracy/Target error" :
                          "Accuracy/Refinement cycles = " + std::to_string(refinement.cycles)) +
                       "; take p4est, or refine by Mesh/Refinements, Contact refinements, Zones");
  }



  template <int dim>
  void
  Scene<dim>::check_finite() const
  {
    const auto refuse = [](const std::string &key, const std::string &why) {
      throw SceneError(key + ": " + why + " with Deformation = finite");
    };
    if (contact.chosen().predictor() == Predictor::normal_stress)
      refuse("Contact method/Method = " + contact.method,
             "is not there; take Lagrange multiplier, penalty, augmented or perturbed Lagrangian");
    if (contact.geometry == ContactGeometry::reference)
      refuse("Contact method/Contact geometry = reference", "surfaces are not where they were");
    for (const Load<dim> &load : loads)
      if (model_of(model) == Model::plane_stress && !load.pressure.is_zero())
        refuse(
          "Loads/" + load.name + "/Pressure = " + load.pressure.formula(),
          "is not there for Model = plane stress, whose edges become thinner: take a Traction,");
    for (const Body<dim> &body : bodies)
      if (body.expansion.given())
        refuse("Bodies/" + body.name + "/Thermal expansion", "is not there");
    if (!goals.quantities.empty())
      refuse("Accuracy/Quantity = " + goals.quantities.front(), "errors are not estimated");
    if (output.linear_reference)
      refuse("Output/Linear reference = yes", "nothing is linear");
    if (solver.stiffness_form == StiffnessForm::matrix_free)
      refuse("Solver/Operator = matrix-free", "tangents are assembled");
  }



  template <int dim>
  void
  Scene<dim>::check_integration() const
  {
    for (const ContactPair<dim> &pair : known_pairs())
      {
        const Integration integration = integration_of(pair);
        contact.chosen().check(integration, degree_of(pair.slave));
        if (integration.rule == Rule::segments && contact.quadrature_points > 7)
          throw SceneError(
            "Contact method/Quadrature points = " + std::to_string(contact.quadrature_points) +
            ": on segments there are rules with up to 7");
      }
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
