// SPDX-License-Identifier: Apache-2.0
#include "scene/decisions.h"

#include "materials/material_law.h"

#include <algorithm>

namespace Signorini
{
  namespace
  {
    /// Poisson's ratio from which degree 1 is too stiff by several per cent, and multigrid takes
    /// twice the number of iterations.
    constexpr double nearly_incompressible = 0.48;

    /// @return why a material cannot be in displacement-pressure form, and what to do about it;
    /// empty if it can.
    template <int dim>
    std::string
    obstacle_to_mixed(const Scene<dim> &scene, const Body<dim> &body, const Material &material)
    {
      if (model_of(scene.model) == Model::plane_stress)
        return "the mixed formulation is not available for Model = plane stress, which does not lock";
      // The degree 0 of a body means that it has none of its own, and that the degree of the mesh
      // holds.
      if (body.degree == 1 || (body.degree == 0 && scene.degree == 1))
        return "the pressure of degree 1 is not stable (inf-sup condition); set Degree = 2";
      if (!(material.poissons_ratio > 0))
        return "requires a Poisson's ratio above 0";
      if (scene.deformation != Deformation::small && material.law == "Saint Venant-Kirchhoff")
        return "Law = Saint Venant-Kirchhoff has no volumetric part; set Law = neo-Hooke";
      return {};
    }

    /// @return whether the user has chosen the displacement-pressure form, or has left it open for
    /// a nearly incompressible material.
    /// @param obstacle to that form, see obstacle_to_mixed()
    bool
    wants_mixed(const Material &material, const std::string &obstacle)
    {
      return material.formulation == Formulation::mixed ||
             (material.formulation == Formulation::automatic &&
              material.poissons_ratio >= nearly_incompressible && obstacle.empty());
    }

    /// @return whether a material is in displacement-pressure form: if the user has chosen it, or
    /// if it is nearly incompressible and nothing in the scene prevents it. Throws SceneError where
    /// it is impossible or required.
    /// @param place of the material in the scene
    template <int dim>
    bool
    is_up_formulation(const Scene<dim>  &scene,
                      const Body<dim>   &body,
                      const Material    &material,
                      const std::string &place)
    {
      const std::string obstacle = obstacle_to_mixed(scene, body, material);
      if (material.formulation == Formulation::mixed && !obstacle.empty())
        throw SceneError(place + "/Formulation = mixed: " + obstacle);
      const bool result = wants_mixed(material, obstacle);
      // Lame's constant lambda is infinite then, so that the displacement form has no finite
      // stiffness.
      if (!result && material.poissons_ratio == 0.5)
        throw SceneError(place + "/Poisson's ratio = 0.5 requires Formulation = mixed" +
                         (obstacle.empty() ? "" : ", but " + obstacle) +
                         "; or set a Poisson's ratio below 0.5");
      return result;
    }

    /// @return whether a body must have degree 2: with degree 1, locking would let the refinement
    /// for a quantity continue without end.
    template <int dim>
    bool
    needs_degree_2(const Scene<dim> &scene, const Material &material)
    {
      return model_of(scene.model) != Model::plane_stress &&
             material.poissons_ratio >= nearly_incompressible && !scene.goals.quantities.empty();
    }
  } // namespace



  // Refinement concerns all bodies, also those beside the one that is refined.
  template <int dim>
  std::string
  Decisions<dim>::needs_hypercubes(const Scene<dim> &scene, const Body<dim> &body)
  {
    if (scene.goals.has_targets())
      return "Accuracy/Target error";
    if (scene.maximum_cycles() > 0)
      return "Accuracy/Refinement cycles";
    if (scene.mesh.refinements > 0 || scene.mesh.contact_refinements > 0 ||
        !scene.mesh.refinement_regions.empty())
      return "the refinement in Mesh";
    for (const Body<dim> &other : scene.bodies)
      if (other.mesh.refinements > 0)
        return "Bodies/" + other.name + "/Refinements";
    if (scene.mesh.distribution == Distribution::p4est)
      return "Mesh/Distribution = p4est";
    if (body.degree == 1 || (body.degree == 0 && scene.degree == 1))
      return "Degree = 1";
    for (const Material *material : body.materials())
      if (material->constitutive_law && material->constitutive_law->n_internal() > 0)
        return "Law = " + material->law;
    return {};
  }



  // For "auto", the method follows from the measurements of doc/benchmarks/accuracy.md: with
  // multipliers there is no parameter and no penetration, at the same cost as other methods.
  // Degrees are chosen body by body.
  template <int dim>
  Decisions<dim>::Decisions(const Scene<dim> &scene)
    : scene(scene)
    , pairs(scene.named_pairs())
    , pairs_are_open(scene.auto_pairs)
    , finite_strain(scene.deformation == Deformation::finite)
  {
    for (const Body<dim> &body : scene.bodies)
      {
        const std::string place   = "Bodies/" + body.name;
        unsigned int      degree  = body.degree > 0 ? body.degree : scene.degree;
        const bool        is_open = degree == 0;
        if (is_open && body.mesh.generator->degree_of_elements() > 0)
          degree = body.mesh.generator->degree_of_elements();
        std::vector<bool> &flags = has_pressure_field.emplace_back();
        for (const Material *material : body.materials())
          {
            const std::string of_cells =
              flags.empty() ? "" : "/Materials/" + body.others[flags.size() - 1].name;
            flags.push_back(is_up_formulation(scene, body, *material, place + of_cells));
            // One material that needs degree 2 decides for the whole body, since the degree is that
            // of a body.
            if (is_open && (flags.back() || needs_degree_2(scene, *material)))
              degree = 2;
          }
        // Degrees that are open may be raised later, by the errors of the first solutions.
        open_degrees.push_back(scene.goals.has_targets() && degree == 0);
        degrees.push_back(std::max(degree, 1u));
      }
    if (!scene.contact.is_automatic())
      return;
    reason = scene.contact.chosen_name() + ", which has no parameter and no penetration";
    if (scene.degree == 0)
      reason += scene.goals.has_targets() ?
                  "; degree 1, or degree 2 for bodies whose errors are far above the target" :
                  "; degree 1, since there is no Target error";
  }



  template <int dim>
  void
  Decisions<dim>::raise_degree(const unsigned int body)
  {
    degrees[body]      = 2;
    open_degrees[body] = false;
  }



  template <int dim>
  std::vector<Material>
  Decisions<dim>::materials(const unsigned int body) const
  {
    std::vector<Material>                    result;
    const std::vector<ThermalExpansion<dim>> thermal = expansions(body);
    // The flags of the displacement-pressure formulation are in the order of the materials of the
    // body.
    for (const Material *material : scene.bodies[body].materials())
      {
        const bool is_up_formulation = has_pressure_field[body][result.size()];
        result.push_back(*material);
        result.back().is_up_formulation = is_up_formulation;
        if (finite_strain && !material->constitutive_law)
          result.back().constitutive_law = law_of(*material).make(result.back());
        auto &law = result.back().constitutive_law;
        if (const auto &expansion = thermal[result.size() - 1]; law && expansion.given())
          law = with_thermal_stretch(law, material->strain_measure, expansion.alpha());
      }
    return result;
  }



  // Sets of cells have the temperature of their body, and may have coefficients of their own.
  template <int dim>
  std::vector<ThermalExpansion<dim>>
  Decisions<dim>::expansions(const unsigned int body) const
  {
    const Body<dim>                   &one = scene.bodies[body];
    std::vector<ThermalExpansion<dim>> result{one.expansion};
    for (const MaterialOfCells &cells : one.others)
      {
        result.push_back(one.expansion);
        if (!cells.expansion.empty())
          result.back().coefficients = cells.expansion;
      }
    return result;
  }



  // Surfaces have names BODY.BOUNDARY; obstacles have no degree.
  template <int dim>
  unsigned int
  Decisions<dim>::degree_of(const std::string &surface) const
  {
    const auto dot = surface.find('.');
    for (unsigned int body = 0; body < degrees.size(); ++body)
      if (dot != std::string::npos && scene.bodies[body].name == surface.substr(0, dot))
        return degrees[body];
    return 0;
  }



  template <int dim>
  Integration
  Decisions<dim>::integration_of(const ContactPair<dim> &pair) const
  {
    const unsigned int slave = degree_of(pair.slave), master = degree_of(pair.master);
    // In an unbiased method each surface is the slave once.
    // The rule must suit both roles of each surface.
    const unsigned int largest = std::max(slave, master);
    return scene.contact.chosen().unbiased() ?
             scene.contact.integration_of_degrees(largest, largest) :
             scene.contact.integration_of_degrees(slave, master);
  }



  // Quantities may refer to pairs, supports, obstacles that can move, and probes of single points.
  template <int dim>
  std::vector<QuantityName>
  Decisions<dim>::quantities() const
  {
    QuantityNames names{
      names_of(pairs), names_of(scene.supports), {}, names_of(scene.bodies), {}, {}};
    for (const Probe<dim> &probe : scene.output.probes)
      if (!probe.is_line())
        (probe.is_on_pair() ? names.surface_probes : names.probes).push_back(probe.name);
    for (const Obstacle<dim> &obstacle : scene.obstacles)
      if (obstacle.body.can_move())
        names.obstacles.push_back(obstacle.name);
    std::vector<QuantityName> result;
    for (const std::string &text : scene.goals.quantities)
      result.push_back(read_quantity(text, "Accuracy/Quantity", names, dim));
    return result;
  }



  // The error by the contact geometry must leave room for the discretisation error within each
  // target.
  template <int dim>
  double
  Decisions<dim>::geometry_tolerance() const
  {
    double result = scene.contact.geometry_share;
    for (const double target : scene.goals.targets)
      // A fifth of the target is left for the discretisation.
      result = std::min(result, 0.8 * target);
    return result;
  }



  // Quantities can be checked only if all pairs are known: automatic pairs are found later, from
  // the mesh.
  template <int dim>
  void
  Decisions<dim>::check() const
  {
    for (const ContactPair<dim> &pair : pairs)
      {
        const Integration integration = integration_of(pair);
        scene.contact.chosen().check(integration, degree_of(pair.slave));
        if (integration.rule == Rule::segments && scene.contact.quadrature_points > 7)
          throw SceneError("Contact method/Quadrature points = " +
                           std::to_string(scene.contact.quadrature_points) +
                           ": with Integration = segments at most 7 are available; set 7 or less");
      }
    if (finite_strain)
      check_finite_strain();
    for (const Load<dim> &load : scene.loads)
      if (!load.fluid_entries.empty() && !scene.goals.quantities.empty())
        throw SceneError("Accuracy/Quantity = " + scene.goals.quantities.front() +
                         ": error bars do not know where the edge of the fluid of Loads/" +
                         load.name + " is; remove it, or its Fluid entry");
    if (scene.contact.chosen().has_late_ties && scene.contact.geometry == ContactGeometry::updated)
      throw SceneError(
        "Contact method/Contact geometry = updated: tied pairs with a Start time have "
        "the points of the undeformed bodies; set automatic or reference");
    if (scene.contact.chosen().has_friction)
      check_friction();
    if (!pairs_are_open)
      quantities();
  }



  template <int dim>
  void
  Decisions<dim>::check_friction() const
  {
    const auto refuse = [](const std::string &key, const std::string &why) {
      throw SceneError(key + ": " + why);
    };
    for (const ContactPair<dim> &pair : pairs)
      if (const Obstacle<dim> *obstacle = scene.obstacle_of(pair);
          obstacle && obstacle->shape->depends_on_time() && !pair.friction.is_zero())
        refuse("Contact pairs/" + pair.name + "/Friction = " + pair.friction.mu.text,
               "the shape of '" + obstacle->name +
                 "' depends on time, so that the motion of its material is not known; move it "
                 "by its Displacement instead");
  }



  // Features that exist at small strain only.
  template <int dim>
  void
  Decisions<dim>::check_finite_strain() const
  {
    const auto refuse = [](const std::string &key, const std::string &why) {
      throw SceneError(key + ": " + why + "; set Deformation = small, or change that key");
    };
    if (scene.contact.geometry == ContactGeometry::reference)
      refuse("Contact method/Contact geometry = reference",
             "is not possible with Deformation = finite, which requires "
             "the current configuration");
    for (const ContactPair<dim> &pair : pairs)
      if (pair.image.turns())
        refuse("Contact pairs/" + pair.name +
                 "/Master rotation = " + short_text(pair.image.rotation),
               "is not available with Deformation = finite");
    for (const ContactPair<dim> &pair : pairs)
      if (pair.is_tied && pair.from > 0)
        refuse("Contact pairs/" + pair.name + "/Start time = " + short_text(pair.from),
               "of tied surfaces is not available with Deformation = finite");
    for (const Load<dim> &load : scene.loads)
      if (model_of(scene.model) == Model::plane_stress && !load.pressure.is_zero())
        refuse(
          "Loads/" + load.name + "/Pressure = " + load.pressure.formula(),
          "is not available for Model = plane stress with Deformation = finite; use a Traction instead");
    if (scene.output.linear_reference)
      refuse("Output/Linear reference = yes", "is not available with Deformation = finite");
  }



  // Choices are repeated from the original scene, since present ones may already have changed.
  template <int dim>
  Scene<dim>
  Decisions<dim>::explicit_scene() const
  {
    const Decisions<dim> before(scene);
    Scene<dim>           result = scene;
    result.contact.method       = scene.contact.chosen_name();
    result.degree               = scene.degree;
    for (unsigned int body = 0; body < result.bodies.size(); ++body)
      if (before.degrees[body] != std::max(scene.degree, 1u))
        result.bodies[body].degree = before.degrees[body];
    return result;
  }



  template <int dim>
  nlohmann::ordered_json
  Decisions<dim>::save() const
  {
    return {{"degrees", degrees},
            {"finite_strain", finite_strain},
            {"penalty_factor", penalty_factor}};
  }



  template <int dim>
  void
  Decisions<dim>::load(const nlohmann::ordered_json &saved)
  {
    for (unsigned int body = 0; body < degrees.size(); ++body)
      // Degrees never decrease during a run, so that a saved degree that is higher was raised by
      // the run.
      if (saved.at("degrees").at(body) > degrees[body])
        raise_degree(body);
    finite_strain  = saved.at("finite_strain");
    penalty_factor = saved.at("penalty_factor");
  }



  template struct Decisions<2>;
  template struct Decisions<3>;
} // namespace Signorini
