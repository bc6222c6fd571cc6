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
    geometric, ///< displacements of degree one on the same mesh, then on coarser ones
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

    /// True if the preconditioner needs the assembled matrix.
    bool
    needs_matrix() const
    {
      return preconditioner != "interface multigrid";
    }
  };
} // namespace Signorini
