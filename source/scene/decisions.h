// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "accuracy/quantity.h"
#include <signorini/scene/scene.h>

#include <nlohmann/json.hpp>

namespace Signorini
{
  /// The choices of the program for a scene, in addition to those of the user: before there is a
  /// mesh (degrees, formulations, the method), on the mesh (pairs, slave side), and after solutions
  /// (finite strain, higher degrees, larger penalties). The scene itself is not changed after it
  /// was read.
  template <int dim>
  struct Decisions
  {
    /// Make all choices that need no mesh. Throws SceneError where a formulation is impossible.
    /// @param scene to which the object refers
    explicit Decisions(const Scene<dim> &scene);

    /// @return what a body needs quadrilaterals or hexahedra for, as the words of a message; empty:
    /// nothing, so that triangles and tetrahedra of its file may be kept. It is decided before
    /// files are read.
    /// @param scene whose keys have been read
    /// @param body of the scene
    static std::string
    needs_hypercubes(const Scene<dim> &scene, const Body<dim> &body);

    const Scene<dim> &scene;

    /// The pairs of the scene, with slave and master as they were chosen; empty while they are
    /// still to be found.
    std::vector<ContactPair<dim>> pairs;
    /// Whether pairs are to be found automatically, and there was no mesh yet.
    bool pairs_are_open;

    /// Polynomial degree of the displacement of each body.
    std::vector<unsigned int> degrees;
    /// For each body whether its degree is 1 and may become 2 for a target.
    std::vector<bool> open_degrees;

    /// Set the degree of a body to 2.
    /// @param body its index
    void
    raise_degree(unsigned int body);

    /// For each body and each of its materials, see materials(), whether it is in
    /// displacement-pressure form.
    std::vector<std::vector<bool>> has_pressure_field;

    bool finite_strain = false;
    /// Factor of all penalties, in addition to those that the user has set.
    double penalty_factor = 1;

    /// A text about the choices that needed no mesh; empty if there were none.
    std::string reason;

    /// @return the materials of a body, its own and those of its sets of cells, in the order of
    /// their ids, with their formulation, and with the law of finite strain if that is used. Laws
    /// contain the thermal expansion of their cells.
    /// @param body its index
    std::vector<Material>
    materials(unsigned int body) const;

    /// @return the thermal expansion that belongs to each of materials().
    /// @param body its index
    std::vector<ThermalExpansion<dim>>
    expansions(unsigned int body) const;

    /// @return the degree of the body of a boundary; 0 for obstacles.
    /// @param surface BODY.BOUNDARY
    unsigned int
    degree_of(const std::string &surface) const;

    /// @return the integration of a pair.
    /// @param pair of the scene
    Integration
    integration_of(const ContactPair<dim> &pair) const;

    /// @return the quantities of interest. Throws SceneError for names that do not exist in the
    /// scene.
    std::vector<QuantityName>
    quantities() const;

    /// @return the relative change of the pressure that contact in the reference configuration may
    /// neglect: that of the scene, or less, so that a target cannot fail because of it.
    double
    geometry_tolerance() const;

    /// Throws SceneError where choices and scene contradict each other: method, integration and
    /// degree, features that do not exist at finite strain, quantities that do not exist.
    void
    check() const;

    /// @return the scene with all choices that needed no mesh as explicit values.
    Scene<dim>
    explicit_scene() const;

    /// @return the choices that a restart could not repeat, except for the pairs, which
    /// ContactInterfaces::save() contains.
    nlohmann::ordered_json
    save() const;

    /// Restore choices.
    /// @param saved result of save() for the same scene
    void
    load(const nlohmann::ordered_json &saved);

  private:
    /// Throws SceneError for features that do not exist at finite strain.
    void
    check_finite_strain() const;
    /// Throws SceneError for features that do not exist with friction.
    void
    check_friction() const;
  };
} // namespace Signorini
