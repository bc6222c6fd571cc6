// SPDX-License-Identifier: Apache-2.0
// What changes from solution to solution of one load step: bonds that fail, and fluids that spread.
#include "driver/equilibrium.h"
#include "solid/fluid_spread.h"
#include <signorini/contact/methods/method.h>

namespace Signorini
{
  using namespace dealii;

  // The forces of contact pressures tell where surfaces are open, on slaves and masters alike.
  // Tied surfaces are sealed, whatever they bear. Methods that take loads on the surfaces from the
  // normal stress search again.
  template <int dim>
  bool
  Equilibrium<dim>::spread_fluids(const FluidSpread spread)
  {
    const GapOperator &points   = contact.gap_operator();
    PointVectors       pressure = points.zeros(), tied = pressure;
    pressure[0] = configuration_solver.contact_state().pressure();
    for (const auto i : pressure[0].locally_owned_elements())
      if (status_of(points.coefficients.least_status(i)) == ContactStatus::stick)
        tied[0](i) = 1;
    tied[0].compress(VectorOperation::insert);
    const bool has_spread = Signorini::spread_fluids(elasticity,
                                                     state.displacement,
                                                     points.total_force(pressure, pressure),
                                                     points.total_force(tied, tied),
                                                     spread);
    if (has_spread && scene.contact.chosen().pressure_shift() == PressureShift::normal_stress)
      configuration_solver.find_contact(true);
    return has_spread;
  }



  // Before the first solution nothing is wet: surfaces first come into contact.
  template <int dim>
  void
  Equilibrium<dim>::start_fluids()
  {
    if (has_fluids(elasticity.loads()) &&
        Utilities::MPI::max(state.contact.empty() ? 0 : 1, elasticity.mesh().communicator()) > 0)
      spread_fluids(FluidSpread::open_faces);
  }



  // Each solution decides which bonds fail next, and where fluids go. Ends since there are finitely
  // many points and faces, and failed bonds and wet faces stay so. Collective.
  template <int dim>
  bool
  Equilibrium<dim>::solve_while_state_changes(const double t, const double tolerance)
  {
    for (;;)
      {
        const bool bonds_fail = configuration_solver.break_bonds();
        if (!bonds_fail &&
            !(has_fluids(elasticity.loads()) && spread_fluids(FluidSpread::next_faces)))
          return true;
        previous_steps = my_report.steps;
        // Where bonds fail, bodies may jump: surfaces are where they were until this is solved.
        const bool is_solved = solve_fixed_configuration(t, {tolerance}) &&
                               (!(my_uses_current_geometry || needs_geometry_update(true)) ||
                                update_geometry_until_converged(t, tolerance, false));
        if (!is_solved)
          {
            my_report.reason +=
              bonds_fail ? "; bonds have failed in this load step (Strength), and the bodies may "
                           "have come apart" :
                           "; a fluid has spread in this load step (Fluid entry), and may have "
                           "pushed the bodies apart";
            return false;
          }
      }
  }



#define INSTANTIATE(dim)                                                                           \
  template bool Equilibrium<dim>::spread_fluids(FluidSpread);                                      \
  template void Equilibrium<dim>::start_fluids();                                                  \
  template bool Equilibrium<dim>::solve_while_state_changes(double, double);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
