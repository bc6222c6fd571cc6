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
    section.add_choice(
      "Preconditioner",
      preconditioner,
      preconditioner_names(),
      "contact filter: exact on the contact zone, multigrid elsewhere, and direct where that does not converge and the "
      "system is not too large (400,000 unknowns in 2D, 60,000 in 3D); block ones and SIMPLE: for "
      "multipliers, by a Schur complement; direct: small problems");
    section.add_choice(
      "Operator",
      stiffness_form,
      or_auto(stiffness_forms()),
      "products with the stiffness from a matrix, or from the cells each time (in three dimensions, degree one and "
      "two); auto: the quicker one, which is the second with degree two, on refined meshes, and of large deformation");
    section.add_choice(
      "Coarsening",
      coarsening,
      coarsenings(),
      "levels of multigrid. geometric: where bodies have a higher degree, degree one on the same mesh; in three dimensions "
      "then coarser meshes, as far as cells have been refined; at last aggregates of nodes. degree: without coarser meshes. "
      "algebraic: aggregates alone");
    section.add_choice(
      "Krylov method",
      krylov,
      or_auto(krylov_methods()),
      "auto: CG; with multipliers and block diagonal MINRES, with block triangular and SIMPLE FGMRES");
    section.add_choice(
      "Schur complement",
      schur_complement,
      SchurComplement::names(),
      "of block preconditioners: from the diagonal of the stiffness; multiplier "
      "mass; from the stiffness of the contact zone; by inner iterations with multigrid");
    section.add(
      "Augmentation",
      augmentation,
      "of block preconditioners: penalty in units of E/h added to the displacement's block, "
      "which then takes a contact filter; 0: none",
      Range{0, 1e12});
    section.add_choice(
      "Direct solver",
      direct_solver,
      or_auto<LA::DirectLibrary>(
        {{"KLU", LA::DirectLibrary::KLU}, {"MUMPS", LA::DirectLibrary::MUMPS}}),
      "of the contact zone or the whole system; auto: the quicker one that is there, KLU for contact zones and "
      "small systems on one rank, else MUMPS");
    section.add_choice(
      "Near null space",
      near_null_space,
      near_null_spaces(),
      "what the multigrid method knows of elasticity; translations alone: less memory, half as many iterations again");
    section.add("Maximum iterations", maximum_iterations, "of one linear solve", positive);
  }
} // namespace Signorini
