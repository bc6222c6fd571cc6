// SPDX-License-Identifier: Apache-2.0
#include "solver/preconditioners/interface_multigrid.h"

#include <limits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The contact stiffness for the multigrid levels [force/length]: that of the system at closed
    /// points; where a multiplier enforces the constraint, that without the multiplier, or the
    /// largest number if there is no compliance (LevelContactStiffness limits it).
    PointVectors
    contact_stiffness(const ContactSystem &system)
    {
      PointVectors      D = system.contact_stiffness();
      const LA::Vector &A = system.coupling();
      for (unsigned int a = 0; a < D.size(); ++a)
        {
          for (const auto i : D[a].locally_owned_elements())
            if (A(i) != 0 && system.constraint()[a][a](i) != 0)
              D[a](i) = system.identity()[a][a](i) > 0 ?
                          A(i) * system.constraint()[a][a](i) / system.identity()[a][a](i) :
                          std::numeric_limits<double>::max();
          D[a].compress(VectorOperation::insert);
        }
      return D;
    }
  } // namespace



  InterfaceMultigrid::InterfaceMultigrid(const ContactSystem    &system,
                                         const Hierarchy        &hierarchy,
                                         const LA::DirectLibrary direct_solver,
                                         const bool              interface_includes_geometric)
    : system(system)
    , amg(hierarchy, &system.gap_operator())
    , n_components(hierarchy.n_components())
    , direct_solver(direct_solver)
    , interface_includes_geometric(interface_includes_geometric)
  {
    // Prepare the rows of K of the potential interface, which contains those of any active set,
    // once.
    system.stiffness().rows(potential_interface_dofs(system));
  }



  // A new active set changes the contact stiffness of the levels and the interface solve:
  // diagonals, one factorisation on the coarsest level, one of the interface. Collective.
  void
  InterfaceMultigrid::update()
  {
    amg.set_contact_stiffness(contact_stiffness(system));
    // With the geometric stiffness, nodes are coupled in all components.
    interface = std::make_unique<InterfaceSolver>(system,
                                                  interface_includes_geometric ?
                                                    active_interface_dofs(system) :
                                                    dominant_interface_dofs(system, n_components),
                                                  direct_solver,
                                                  interface_includes_geometric);
    if (interface->size() > 0)
      interface->update();
  }



  void
  InterfaceMultigrid::start(LA::BlockVector &x, const LA::BlockVector &rhs) const
  {
    if (interface->size() > 0)
      interface->add_correction(x, rhs);
  }



  // Apply the preconditioner to a vector of displacements, for block preconditioners with
  // augmentation.
  void
  InterfaceMultigrid::solve(LA::Vector &dst, const LA::Vector &src) const
  {
    LA::BlockVector x = system.zero(), right = x;
    right.block(0) = src;
    correct_first(x, right);
    dst = x.block(0);
  }



  // The preconditioner (7.6), or (7.7) where residuals vanish on the interface.
  void
  InterfaceMultigrid::vmult(LA::BlockVector &dst, const LA::BlockVector &src) const
  {
    // The residual on the interface does not vanish if F contains a stabilisation that the system
    // does not, or if a volumetric stress changes it in each application.
    if (interface->size() > 0 && (!system.unconstrained_modes().empty() || system.volumetric()))
      correct_first(dst, src);
    else
      cycle_and_correct(dst, src);
  }



  // The full form (7.6): interface solve, residual, then cycle and interface solve.
  void
  InterfaceMultigrid::correct_first(LA::BlockVector &dst, const LA::BlockVector &src) const
  {
    dst = 0;
    start(dst, src);
    LA::BlockVector rest = src, correction = src, force = src;
    system.contact_terms(force, dst);
    system.stiffness().vmult_add(force.block(0), dst.block(0));
    rest -= force;
    cycle_and_correct(correction, rest);
    dst += correction;
  }



  // The form (7.7): multigrid cycle, then interface solve for the rest of the residual.
  void
  InterfaceMultigrid::cycle_and_correct(LA::BlockVector &dst, const LA::BlockVector &src) const
  {
    dst = 0;
    amg.vmult(dst.block(0), src.block(0));
    if (interface->size() > 0)
      interface->correct(dst, src);
  }
} // namespace Signorini
