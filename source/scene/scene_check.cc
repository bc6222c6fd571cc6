// SPDX-License-Identifier: Apache-2.0
#include "scene/decisions.h"
#include <signorini/parameters/raw.h>

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// @return all names BODY.BOUNDARY.
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

    /// @return all names BODY.SET of node sets.
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

    /// @return all names BODY.SET of cell sets.
    template <int dim>
    std::vector<std::string>
    cell_set_names(const std::vector<Body<dim>> &bodies)
    {
      std::vector<std::string> names;
      for (const Body<dim> &body : bodies)
        for (const std::string &set : body.mesh.generator->cell_sets())
          names.push_back(body.name + "." + set);
      return names;
    }

    /// @return whether a name is BODY.NUMBER of a node of a mesh file.
    template <int dim>
    bool
    is_node_number(const std::vector<Body<dim>> &bodies, const std::string &name)
    {
      for (const Body<dim> &body : bodies)
        if (const std::string start = body.name + "."; name.compare(0, start.size(), start) == 0)
          return !body.mesh.generator->node_set(name.substr(start.size())).nodes.empty();
      return false;
    }

    /// Throws SceneError if the moduli of bodies differ so much that the rounding errors of the
    /// stiff body are forces on the soft one.
    template <int dim>
    void
    check_contrast(const std::vector<Body<dim>> &bodies)
    {
      constexpr double                            largest = 1e8;
      std::vector<std::pair<double, std::string>> moduli;
      for (const Body<dim> &body : bodies)
        for (const Material *material : body.materials())
          moduli.emplace_back(material->youngs_modulus, body.name);
      const auto [soft, stiff] = std::minmax_element(moduli.begin(), moduli.end());
      if (stiff->first > largest * soft->first)
        throw SceneError("Bodies/" + stiff->second +
                         "/Young's modulus: more than 1e8 times that of '" + soft->second +
                         "', too much for double precision; model a rigid body as an obstacle");
    }

    /// Throws SceneError for what bodies of triangles or tetrahedra cannot do.
    template <int dim>
    void
    check_simplices(const Scene<dim> &scene)
    {
      for (const Body<dim> &body : scene.bodies)
        {
          if (!body.mesh.generator->has_simplices())
            continue;
          const std::string place = "Bodies/" + body.name + "/Cells = as in file",
                            cells = word_of_cells(dim, true),
                            cure  = "; set Cells = " + word_of_cells(dim, false);
          if (scene.maximum_cycles() > 0)
            throw SceneError(
              place + ": " + cells + " are not refined, but " +
              (scene.goals.has_targets() ? "Accuracy/Target error" : "Accuracy/Refinement cycles") +
              " is set" + cure);
          for (const Material *material : body.materials())
            if (material->constitutive_law && material->constitutive_law->n_internal() > 0)
              throw SceneError(place + ": Law = " + material->law +
                               " has internal variables, which are not available on " + cells +
                               cure);
        }
    }

    /// Throws SceneError for motions of obstacles that violate axial symmetry.
    template <int dim>
    void
    check_axisymmetric(const Scene<dim> &scene)
    {
      if (model_of(scene.model) != Model::axisymmetric)
        return;
      for (const Load<dim> &load : scene.loads)
        if (load.total_moment.given() || !load.reference.empty())
          throw SceneError(load.place +
                           ": with Model = axisymmetric a load has no Total moment and no "
                           "Reference point; remove these");
      for (const Obstacle<dim> &obstacle : scene.obstacles)
        {
          const RigidBody<dim> &body = obstacle.body;
          const bool            sideways =
            body.displacement.given() && (body.is_free(0) || !body.displacement.is_zero(0));
          if (sideways || body.rotation.given())
            throw SceneError(
              "Obstacles/" + obstacle.name +
              ": with Model = axisymmetric an obstacle can move along the axis only; "
              "set Displacement = 0; ... and no Rotation");
        }
    }

    /// Throws SceneError if a mesh consists of touching pieces whose interaction is not specified.
    template <int dim>
    void
    check_pieces(const Scene<dim> &scene)
    {
      for (const Body<dim> &body : scene.bodies)
        {
          const std::string reason = body.mesh.generator->needs_pair(), start = body.name + ".";
          bool              joined = false;
          for (const ContactPair<dim> &pair : scene.named_pairs())
            joined |= pair.image.is_master() && pair.slave.compare(0, start.size(), start) == 0 &&
                      pair.master.compare(0, start.size(), start) == 0;
          if (!reason.empty() && !joined)
            throw SceneError(reason);
        }
    }

    /// Throws SceneError if two pairs have the same surfaces at the same time: the distribution of
    /// the pressure among them would not be determined.
    template <int dim>
    void
    check_same_pairs(const std::vector<ContactPair<dim>> &pairs)
    {
      for (unsigned int i = 0; i < pairs.size(); ++i)
        for (unsigned int j = 0; j < i; ++j)
          if (((pairs[i].slave == pairs[j].slave && pairs[i].master == pairs[j].master) ||
               (pairs[i].slave == pairs[j].master && pairs[i].master == pairs[j].slave)) &&
              pairs[i].overlaps(pairs[j]))
            throw SceneError(
              pairs[i].slave_location + ": pairs '" + pairs[j].name + "' and '" + pairs[i].name +
              "' have the same surfaces; remove one, or let one end (End time) before the "
              "other starts");
    }

    /// Throws SceneError if a pair with an obstacle in the place of the slave can open.
    template <int dim>
    void
    check_attached(const Scene<dim> &scene, const ContactPair<dim> &pair)
    {
      const Obstacle<dim> *obstacle = scene.obstacle_of(pair);
      if (obstacle && obstacle->shape->is_attached() && pair.can_separate)
        throw SceneError(pair.master_location + ": '" + obstacle->name +
                         "' is attached to the surface (Shape), and holds it; set Law = tied, or "
                         "Separation = none, or another Shape");
    }

    /// Throws SceneError where the slave of a pair cannot meet its master elsewhere.
    template <int dim>
    void
    check_image(const Scene<dim> &scene, const ContactPair<dim> &pair)
    {
      if (pair.master_is_in_place())
        return;
      const Pretension<dim> &pretension = pair.pretension;
      const std::string      key        = pair.image.turns()        ? "Master rotation" :
                                          !pair.image.is_master()   ? "Master shift" :
                                          !pretension.force.empty() ? "Pretension" :
                                                                      "Shortening",
                        place           = pair.master_location + ": " + key + " ";
      if (pretension.given() && !pair.image.is_master())
        throw SceneError(place + "does not go with a pretension; remove one of them");
      if (scene.obstacle_of(pair))
        throw SceneError(place + "applies to surfaces of bodies; '" + pair.master +
                         "' is an obstacle, which can be " +
                         (pretension.given() ? "moved" : "placed as it should be"));
      if (pretension.given() && pair.until > 0)
        throw SceneError(place + "requires surfaces that are always tied; remove End time");
      if (scene.contact.chosen().unbiased())
        throw SceneError(place +
                         "requires a slave and a master; set Contact method/Nitsche/Unbiased "
                         "= no, or another method");
      if (pair.image.turns() && model_of(scene.model) == Model::axisymmetric)
        throw SceneError(place + "does not apply to Model = axisymmetric");
      if (pair.image.turns() && scene.deformation == Deformation::automatic)
        throw SceneError(place + "requires Deformation = small");
    }

    /// Throws SceneError for keys that do not apply to self-contact.
    template <int dim>
    void
    check_self(const ContactPair<dim> &pair)
    {
      const std::string place = pair.master_location + ": self-contact ";
      if (pair.gap_is_given() || pair.closes_below >= 0)
        throw SceneError(
          place + "requires the gaps of the geometry; remove Initial gap and Closure tolerance");
      if (!pair.can_separate)
        throw SceneError(place + "requires Separation = allowed; remove Separation");
    }

    /// Throws SceneError, with a similar name if there is one, for names that do not exist.
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
              throw SceneError(
                place + ": '" + name +
                "' is a node set that contains no complete face; use the key Nodes of "
                "supports and loads");
            throw SceneError(place + ": there is no " + what + " '" + name + "'" +
                             (close.empty() ? "." : "; did you mean '" + close + "'?") +
                             " There are: " + join(existing) + ".");
          }
    }
  } // namespace



  // Names first, since later checks rely on them: bodies, boundaries, node and cell sets, pairs;
  // then combinations of choices.
  template <int dim>
  void
  Scene<dim>::check() const
  {
    if (bodies.empty())
      throw SceneError("Bodies/Names: a scene needs at least one body");
    for (const Body<dim> &body : bodies)
      body.check();
    // All names that entries may refer to. A boundary may also be a node set of a mesh file, and a
    // load on bodies may name a set of cells.
    const auto body_names     = names_of(bodies);
    const auto obstacle_names = names_of(obstacles);
    const auto boundaries     = boundary_names(bodies);
    const auto sets           = node_set_names(bodies);
    auto       with_cells     = cell_set_names(bodies);
    with_cells.insert(with_cells.begin(), body_names.begin(), body_names.end());
    // Throws SceneError if a choice of nodes names a set or a body that does not exist.
    const auto require_nodes = [&](const NodeChoice &nodes) {
      std::vector<std::string> named; // the others are numbers of nodes
      for (const std::string &set : nodes.sets)
        if (!is_node_number(bodies, set))
          named.push_back(set);
      require("set of nodes", named, sets, nodes.sets_location);
      if (!nodes.body.empty())
        require("body", {nodes.body}, body_names, nodes.point_location);
    };
    // The names in supports, loads and contact pairs.
    for (const Support<dim> &support : supports)
      {
        require("boundary", support.boundaries, boundaries, support.place, sets);
        require_nodes(support.nodes);
      }
    for (const ConstraintEquations<dim> &set : equations)
      for (const auto &equation : set.equations)
        for (const auto &term : equation)
          if (!is_node_number(bodies, term.node) &&
              std::find(sets.begin(), sets.end(), term.node) == sets.end())
            throw SceneError(
              set.place + ": there is no node '" + term.node +
              "'; write BODY.NUMBER, with the number of the node in the mesh file of "
              "the body");
    for (const Load<dim> &load : loads)
      {
        require("boundary", load.boundaries, boundaries, load.place, sets);
        require_nodes(load.nodes);
        require("body or set of cells", load.bodies, with_cells, load.bodies_location);
      }
    // The master of a pair is a boundary or a rigid obstacle, so their names must differ.
    std::vector<std::string> masters = boundaries;
    masters.insert(masters.end(), obstacle_names.begin(), obstacle_names.end());
    for (const ContactPair<dim> &pair : named_pairs())
      {
        require("boundary", {pair.slave}, boundaries, pair.slave_location, sets);
        require("boundary or obstacle", {pair.master}, masters, pair.master_location, sets);
        if (pair.is_self())
          check_self(pair);
        check_attached(*this, pair);
        check_image(*this, pair);
        if (obstacle_of(pair) && std::count(boundaries.begin(), boundaries.end(), pair.master))
          throw SceneError(pair.master_location +
                           ": is the name of a boundary and of an obstacle; rename the obstacle");
      }
    check_same_pairs(named_pairs());
    for (const RefinementRegion<dim> &region : mesh.refinement_regions)
      require("body", region.bodies, body_names, region.place);
    // All names exist. The following checks concern combinations of bodies, materials and methods.
    check_pieces(*this);
    check_axisymmetric(*this);
    check_contrast(bodies);
    Decisions<dim>(*this).check();
    check_simplices(*this);
    if (mesh.distribution == Distribution::METIS && maximum_cycles() > 0)
      throw SceneError(
        "Mesh/Distribution = METIS cannot refine the mesh, but " +
        (goals.has_targets() ?
           "Accuracy/Target error is set" :
           "Accuracy/Refinement cycles = " + std::to_string(refinement.cycles)) +
        "; set p4est, or use Mesh/Refinements, Contact refinements, Refinement regions");
  }



  template void
  Scene<2>::check() const;
  template void
  Scene<3>::check() const;
} // namespace Signorini
