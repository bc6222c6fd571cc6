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

  // As the scene file calls them.

  const Choices<Krylov> &
  krylov_methods();

  const Choices<NearNullSpace> &
  near_null_spaces();

  const Choices<Coarsening> &
  coarsenings();

  struct LinearSolverSettings
  {
    std::optional<StiffnessForm>     stiffness_form; ///< none: the quicker one
    Coarsening                       coarsening     = Coarsening::geometric;
    std::string                      preconditioner = "interface multigrid";
    std::optional<Krylov>            krylov; ///< none: what suits system and preconditioner
    std::string                      schur_complement = "interface";
    double                           augmentation     = 0;
    std::optional<LA::DirectLibrary> direct_solver; ///< none: the quicker one
    NearNullSpace                    near_null_space    = NearNullSpace::rigid_body_modes;
    unsigned int                     maximum_iterations = 1000;

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
