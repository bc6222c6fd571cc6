// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "accuracy/quantity.h"
#include <signorini/scene/scene.h>

#include <nlohmann/json.hpp>

namespace Signorini
{
  /// What the program decides about a scene, beside what the user said in it: before there is a
  /// mesh (degrees, formulations, the method), on the mesh (which pairs there are, which side is
  /// the slave), and by solutions (finite strain, higher degrees, stiffer penalties). The scene
  /// itself never changes after it was read.
  template <int dim>
  struct Decisions
  {
    /// Decide all that needs no mesh. Keeps a reference to the scene. Throws SceneError where a
    /// formulation is impossible.
    explicit Decisions(const Scene<dim> &scene);

    const Scene<dim> &scene;

    /// Those of the scene with the slave that was chosen; none while they are still to be found.
    std::vector<ContactPair<dim>> pairs;
    bool                          pairs_are_open; ///< Names = auto, and there was no mesh yet

    std::vector<unsigned int> degrees;      ///< of the displacement, one a body
    std::vector<bool>         open_degrees; ///< one a body: degree 1 that may become 2 for a target

    /// Degree 2 from here on.
    void
    raise_degree(unsigned int body);

    /// Displacement and pressure are unknowns, one flag a material of each body, see materials().
    std::vector<std::vector<bool>> has_pressure_field;

    bool   finite_strain  = false;
    double penalty_factor = 1; ///< of all penalties, beside those that the user set

    /// What was chosen before there was a mesh, and why, in words; empty: nothing.
    std::string reason;

    /// What a body consists of: its own material and those of its sets of cells, in the order of
    /// their ids, with the formulation, and the law of finite strain if that is decided.
    std::vector<Material>
    materials(unsigned int body) const;

    /// Degree of the body that a boundary BODY.BOUNDARY belongs to; 0 for obstacles.
    unsigned int
    degree_of(const std::string &surface) const;

    Integration
    integration_of(const ContactPair<dim> &pair) const;

    /// Quantities of Accuracy/Quantity. Throws SceneError for those that the scene has not.
    std::vector<QuantityName>
    quantities() const;

    /// Share of the pressure that contact on the surfaces at rest may neglect: that of the scene,
    /// or less, so that it is not what a target fails for.
    double
    geometry_tolerance() const;

    /// Throws SceneError where decisions and scene contradict each other: method, integration and
    /// degree, what does not go with finite strain, quantities that do not exist.
    void
    check() const;

    /// The scene with what needed no mesh to be decided as if the user had said it.
    Scene<dim>
    explicit_scene() const;

    /// What a restart could not decide again by itself, but for the pairs, which
    /// ContactInterfaces::save() has.
    nlohmann::ordered_json
    save() const;

    /// @param saved by save(), of the same scene
    void
    load(const nlohmann::ordered_json &saved);

  private:
    /// Throws SceneError for what does not go with finite strain.
    void
    check_finite_strain() const;
  };
} // namespace Signorini
