// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/accuracy/goals.h>
#include <signorini/accuracy/known_solution.h>
#include <signorini/accuracy/refinement_settings.h>
#include <signorini/contact/obstacles/obstacle.h>
#include <signorini/contact/pair.h>
#include <signorini/mesh/body_mesh.h>
#include <signorini/mesh/mesh_settings.h>
#include <signorini/parameters/raw.h>
#include <signorini/scene/contact_settings.h>
#include <signorini/scene/expected_result.h>
#include <signorini/scene/load_steps.h>
#include <signorini/scene/output_settings.h>
#include <signorini/solid/boundary_conditions.h>
#include <signorini/solid/model.h>
#include <signorini/solid/thermal_expansion.h>
#include <signorini/solver/linear_solver_settings.h>
#include <signorini/solver/newton_settings.h>

namespace Signorini
{
  /// What a set of cells of a body is made of, instead of the body's own material.
  struct MaterialOfCells
  {
    std::string         name, cells; ///< the set, as the mesh file calls it
    std::string         place;       ///< of the set in the scene file
    Material            material;
    std::vector<double> expansion; ///< as ThermalExpansion::coefficients; empty: as the body's

    void
    declare(Section &section);
  };

  /// An elastic body: a mesh, a material, and a temperature if that matters.
  template <int dim>
  struct Body
  {
    std::string                  name;
    unsigned int                 degree = 0; ///< of the displacement; 0: that of all bodies
    BodyMesh<dim>                mesh;
    Material                     material;
    ThermalExpansion<dim>        expansion;
    std::vector<MaterialOfCells> others; ///< beside `material`

    void
    declare(Section &section);

    /// `material` and the others, in the order of their ids.
    std::vector<const Material *>
    materials() const;

    /// Throws SceneError where the body refers to what its mesh does not have.
    void
    check() const;
  };

  template <typename Items>
  std::vector<std::string>
  names_of(const Items &items)
  {
    std::vector<std::string> names;
    for (const auto &item : items)
      names.push_back(item.name);
    return names;
  }

  /// How much bodies may deform.
  enum class Deformation
  {
    small,    ///< strains and rotations are small beside one
    finite,   ///< any amount (doc/theory, 6)
    automatic ///< small, until a solution shows that this neglects too much
  };

  /// All that the user said, in the order of the scene file, which is the order of the data.
  /// Nothing of it changes after it was read; what the program decides are Decisions.
  template <int dim>
  struct Scene
  {
    std::string model             = model_names<dim>().front();
    Deformation deformation       = Deformation::small;
    double      deformation_share = 0.01; ///< of the work that automatic does not become finite for
    std::string title;
    std::string skipped_items; ///< by an import, see skipped_in()
    std::string name;          ///< of the scene file, without folder and .prm
    RawSection  given;         ///< what was read

    Definitions                   definitions;
    std::vector<Body<dim>>        bodies;
    std::vector<Obstacle<dim>>    obstacles;
    std::vector<Support<dim>>     supports;
    std::vector<Load<dim>>        loads;
    std::vector<ContactPair<dim>> pairs;
    bool auto_pairs = false; ///< to be found: the one pair says what they have in common
    MeshSettings<dim>           mesh;
    unsigned int                degree = 1; ///< of bodies that do not say theirs; 0: by the target
    bool                        degree_is_set = false; ///< the user has set that
    ContactSettings             contact;
    Goals                       goals;
    RefinementSettings          refinement;
    LoadSteps                   load_steps;
    NewtonSettings              newton;
    LinearSolverSettings        solver;
    OutputSettings<dim>         output;
    KnownSolution<dim>          known;
    std::vector<ExpectedResult> expected;

    std::vector<std::string> notes; ///< of what was read from files, for the user

    void
    declare(Section &section);

    /// Read the files that the scene names, relative to the present folder, or to that of the
    /// scene. Throws SceneError where they are not good, or without what the scene names in them.
    void
    read_files(const std::string &folder);

    /// Everything that can be wrong before a mesh is made: names that do not exist, choices that
    /// contradict each other. Throws SceneError.
    void
    check() const;

    /// The pairs that the user names; none where Names = auto.
    std::vector<ContactPair<dim>>
    named_pairs() const
    {
      return auto_pairs ? std::vector<ContactPair<dim>>() : pairs;
    }

    /// Meshes that are refined, at most.
    unsigned int
    maximum_cycles() const;

    /// The obstacle that is a pair's master, or null.
    const Obstacle<dim> *
    obstacle_of(const ContactPair<dim> &pair) const;

  private:
    /// Throws SceneError where a support begins after the end.
    void
    end_steps_at_support_changes();
  };
} // namespace Signorini
