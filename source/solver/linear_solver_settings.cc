// SPDX-License-Identifier: Apache-2.0
#include "solver/preconditioner.h"
#include "solver/preconditioners/schur_complement.h"
#include <signorini/parameters/section.h>
#include <signorini/solver/linear_solver_settings.h>

namespace Signorini
{
  const Choices<Krylov> &
  krylov_methods()
  {
    static const Choices<Krylov> list = {{"CG", Krylov::CG},
                                         {"MINRES", Krylov::MINRES},
                                         {"FGMRES", Krylov::FGMRES}};
    return list;
  }



  const Choices<NearNullSpace> &
  near_null_spaces()
  {
    static const Choices<NearNullSpace> list = {{"rigid body modes",
                                                 NearNullSpace::rigid_body_modes},
                                                {"translations", NearNullSpace::translations}};
    return list;
  }



  const Choices<Coarsening> &
  coarsenings()
  {
    static const Choices<Coarsening> list = {{"geometric", Coarsening::geometric},
                                             {"degree", Coarsening::degree},
                                             {"algebraic", Coarsening::algebraic}};
    return list;
  }



  void
  LinearSolverSettings::declare(Section &section)
  {
    section.rename_choice("Preconditioner", "contact filter", "interface multigrid");
    section.add_choice(
      "Preconditioner",
      preconditioner,
      preconditioner_names(),
      "interface multigrid: multigrid with an exact solve on the contact interface; falls back to a direct solver if it "
      "does not converge and the system is small enough (400,000 unknowns in 2D, 60,000 in 3D); block diagonal, block "
      "triangular, SIMPLE: for systems with multipliers, with a Schur complement; direct: for small problems");
    section.add_choice(
      "Operator",
      stiffness_form,
      or_auto(stiffness_forms()),
      "products with the stiffness matrix: assembled: sparse matrix; matrix-free: cell by cell (3D, degrees 1 and 2); "
      "auto: the faster one, which is matrix-free in 3D, except for tetrahedra of degree 1 at small strain");
    section.add_choice(
      "Coarsening",
      coarsening,
      coarsenings(),
      "levels of multigrid. geometric: degree 1 on the same mesh for bodies of higher degree; then, in 3D, the coarser "
      "meshes of the refinement; then regular grids, and smoothed aggregation for thin bodies. degree: degree 1, then "
      "smoothed aggregation. algebraic: smoothed aggregation only");
    section.add_choice(
      "Krylov method",
      krylov,
      or_auto(krylov_methods()),
      "auto: CG; with multipliers and block diagonal MINRES, with block triangular and SIMPLE FGMRES");
    section.rename_choice("Schur complement", "zone", "interface");
    section.add_choice(
      "Schur complement",
      schur_complement,
      SchurComplement::names(),
      "approximation of the Schur complement in block preconditioners: from the diagonal of the stiffness; the "
      "scaled multiplier mass; from the stiffness of the contact interface; by inner iterations with multigrid");
    section.add(
      "Augmentation",
      augmentation,
      "of block preconditioners: penalty in units of E/h that is added to the displacement block, "
      "which is then solved by interface multigrid; 0: none",
      Range{0, 1e12});
    section.add_choice(
      "Direct solver",
      direct_solver,
      or_auto<LA::DirectLibrary>({{"SparseLU", LA::DirectLibrary::SparseLU},
                                  {"KLU", LA::DirectLibrary::KLU},
                                  {"MUMPS", LA::DirectLibrary::MUMPS}}),
      "library for direct solves on the contact interface and of the whole system; auto: the faster one that is installed, "
      "SparseLU (of Eigen) for interfaces and small systems on one rank, else MUMPS");
    section.add_choice(
      "Near null space",
      near_null_space,
      near_null_spaces(),
      "near null space of smoothed aggregation; translations: less memory, but 50 % more iterations");
    section.add("Maximum iterations", maximum_iterations, "of one linear solve", positive);
  }
} // namespace Signorini
