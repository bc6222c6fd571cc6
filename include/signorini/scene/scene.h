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
#include <signorini/solid/constraint_equations.h>
#include <signorini/solid/model.h>
#include <signorini/solid/thermal_expansion.h>
#include <signorini/solver/linear_solver_settings.h>
#include <signorini/solver/newton_settings.h>

namespace Signorini
{
  /// The material of a set of cells, instead of that of the body.
  struct MaterialOfCells
  {
    /// Name of the item, and of the cell set in the mesh file.
    std::string name, cells;
    /// Position of the cell set in the scene file.
    std::string place;
    Material    material;
    /// As ThermalExpansion::coefficients; empty: those of the body.
    std::vector<double> expansion;

    /// Declare the keys and read their values. Throws SceneError.
    /// @param section of the item
    void
    declare(Section &section);
  };

  /// An elastic body: a mesh, materials, and possibly thermal expansion.
  template <int dim>
  struct Body
  {
    std::string name;
    /// Polynomial degree of the displacement; 0: that of all bodies.
    unsigned int          degree = 0;
    BodyMesh<dim>         mesh;
    Material              material;
    ThermalExpansion<dim> expansion;
    /// Materials of sets of cells, in addition to `material`.
    std::vector<MaterialOfCells> others;

    /// Declare the keys and read their values. Throws SceneError.
    /// @param section of the body
    void
    declare(Section &section);

    /// @return `material` and the others, in the order of their ids.
    std::vector<const Material *>
    materials() const;

    /// Throws SceneError where the body refers to sets that its mesh does not have.
    void
    check() const;
  };

  /// @return the names of items.
  /// @param items any container of objects with a name
  template <typename Items>
  std::vector<std::string>
  names_of(const Items &items)
  {
    std::vector<std::string> names;
    for (const auto &item : items)
      names.push_back(item.name);
    return names;
  }

  /// The kinematics of all bodies.
  enum class Deformation
  {
    /// Strains and rotations are small compared with one.
    small,
    /// Any strains and rotations (doc/theory, 6).
    finite,
    /// Small, until a solution shows that this neglects too much.
    automatic
  };

  /// A scene: all input of the user, in the order of the scene file, which is the order in which
  /// the data are used. It is not changed after it was read; the choices of the program are
  /// Decisions.
  template <int dim>
  struct Scene
  {
    std::string model       = model_names<dim>().front();
    Deformation deformation = Deformation::small;
    /// Share of the work that small strain may neglect with Deformation::automatic.
    double      deformation_share = 0.01;
    std::string title;
    /// Features that an import has omitted, see skipped_in().
    std::string skipped_items;
    /// Name of the scene file, without folder and .prm.
    std::string name;
    /// The contents of the file.
    RawSection given;

    Definitions                           definitions;
    std::vector<Body<dim>>                bodies;
    std::vector<Obstacle<dim>>            obstacles;
    std::vector<Support<dim>>             supports;
    std::vector<ConstraintEquations<dim>> equations;
    std::vector<Load<dim>>                loads;
    std::vector<ContactPair<dim>>         pairs;
    /// Whether pairs are to be found; then the only pair has their common properties.
    bool              auto_pairs = false;
    MeshSettings<dim> mesh;
    /// Degree of bodies without one of their own; 0: chosen by the target.
    unsigned int                degree = 0;
    ContactSettings             contact;
    Goals                       goals;
    RefinementSettings          refinement;
    LoadSteps                   load_steps;
    NewtonSettings              newton;
    LinearSolverSettings        solver;
    OutputSettings<dim>         output;
    KnownSolution<dim>          known;
    std::vector<ExpectedResult> expected;

    /// Messages about files, for the user.
    std::vector<std::string> notes;

    /// Declare all keys and read their values. Throws SceneError.
    /// @param section the whole file
    void
    declare(Section &section);

    /// Read the files that the scene names, relative to the current folder, or to that of the
    /// scene. Throws SceneError if they are not valid, or lack names of the scene.
    /// @param folder of the scene file
    void
    read_files(const std::string &folder);

    /// Throws SceneError for everything that can be wrong before a mesh is made: names that do not
    /// exist, choices that contradict each other.
    void
    check() const;

    /// @return the pairs that the user has named; empty with Names = auto.
    std::vector<ContactPair<dim>>
    named_pairs() const
    {
      return auto_pairs ? std::vector<ContactPair<dim>>() : pairs;
    }

    /// @return messages about bodies that are parts of one file with common faces, and that no
    /// contact pair joins.
    std::vector<std::string>
    bodies_that_come_apart() const;

    /// @return the largest number of refinement cycles.
    unsigned int
    maximum_cycles() const;

    /// @return the obstacle that is the master of a pair; null if there is none.
    /// @param pair of the scene
    const Obstacle<dim> *
    obstacle_of(const ContactPair<dim> &pair) const;

  private:
    /// Let load steps end where supports begin or end. Throws SceneError where a support begins
    /// after the end of the load history.
    void
    end_steps_at_changes();
  };
} // namespace Signorini
