// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/linear_algebra/direct_library.h>
#include <signorini/parameters/choices.h>
#include <signorini/solid/stiffness_form.h>

#include <optional>
#include <string>

namespace Signorini
{
  class Section;

  /// Krylov methods for the contact system; FGMRES admits preconditioners that are not linear.
  enum class Krylov
  {
    CG,
    MINRES,
    FGMRES
  };

  /// The near-null space of elasticity that the multigrid method represents on all levels.
  enum class NearNullSpace
  {
    rigid_body_modes,
    translations
  };

  /// The levels below the stiffness itself, before those of aggregates.
  enum class Coarsening
  {
    geometric, ///< displacements of degree one on the same mesh, on coarser ones, on grids
    degree,    ///< the first alone
    algebraic  ///< none
  };

  // Names of the choices in the scene file.

  /// The Krylov methods by the names that the scene file uses.
  const Choices<Krylov> &
  krylov_methods();

  /// The near null spaces by the names that the scene file uses.
  const Choices<NearNullSpace> &
  near_null_spaces();

  /// The kinds of coarsening by the names that the scene file uses.
  const Choices<Coarsening> &
  coarsenings();

  /// What the solver must know of a preconditioner before it makes it.
  struct PreconditionerTraits
  {
    /// It needs the stiffness as a matrix, so that matrix-free operators cannot be used.
    bool needs_matrix = true;
    /// It uses multigrid levels of the bodies, for which costs are predicted.
    bool uses_hierarchy = true;
    /// It factorises the whole system, without the contact geometric stiffness.
    bool factorises = false;
    /// It solves the contact interface exactly. Where it converges slowly, that solve can include
    /// the contact geometric stiffness, and small systems are factorised instead.
    bool solves_interface = false;
    /// It can be combined with Solver/Augmentation.
    bool admits_augmentation = true;
  };

  /// The settings of the linear solver, section Solver of a scene.
  struct LinearSolverSettings
  {
    /// Form of the stiffness; not set: the faster one.
    std::optional<StiffnessForm> stiffness_form;
    Coarsening                   coarsening     = Coarsening::geometric;
    std::string                  preconditioner = "interface multigrid";
    /// Krylov method; not set: the one that suits system and preconditioner.
    std::optional<Krylov> krylov;
    /// Approximation of the Schur complement, for block preconditioners.
    std::string schur_complement = "interface";
    /// Factor gamma of the augmentation k W of block preconditioners; 0: none.
    double augmentation = 0;
    /// Library for factorisations; not set: the faster one.
    std::optional<LA::DirectLibrary> direct_solver;
    NearNullSpace                    near_null_space = NearNullSpace::rigid_body_modes;
    /// Maximal number of Krylov iterations in one solution.
    unsigned int maximum_iterations = 1000;

    /// Declare the keys.
    void
    declare(Section &section);

    /// @return what the solver must know of the preconditioner before it makes it.
    const PreconditionerTraits &
    traits() const;
  };
} // namespace Signorini
