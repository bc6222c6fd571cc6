// SPDX-License-Identifier: Apache-2.0
// What changes from solution to solution of one load step: bonds that fail, and fluids that spread.
#include "driver/equilibrium.h"
#include "solid/fluid_spread.h"
#include <signorini/contact/methods/method.h>

namespace Signorini
{
  using namespace dealii;

  /// Gaps of surfaces that touch, relative to the size of the model.
  static constexpr double rounding_of_gaps = 1e-10;

  // The forces of contact pressures tell where surfaces are closed, on slaves and masters alike.
  // Tied surfaces are sealed, whatever they bear. Methods that take loads on the surfaces from the
  // normal stress search again.
  template <int dim>
  bool
  Equilibrium<dim>::spread_fluids(const FluidSpread spread)
  {
    const GapOperator  &points   = contact.gap_operator();
    const ContactState &state_of = configuration_solver.contact_state();
    const double        near     = rounding_of_gaps * elasticity.mesh().size();
    const LA::Vector    gaps     = points.gap(state.displacement);
    PointVectors        pressure = points.zeros(), touching = points.zeros(), tied = points.zeros();
    for (const auto i : gaps.locally_owned_elements())
      {
        const double pressure_at = state_of.pressure()(i);
        pressure[0](i)           = pressure_at;
        touching[0](i) =
          is_closed(state_of.status(i)) || pressure_at > 0 || gaps(i) <= near ? 1. : 0.;
        tied[0](i) =
          status_of(points.coefficients.least_status(i)) == ContactStatus::stick ? 1. : 0.;
      }
    for (PointVectors *one : {&pressure, &touching, &tied})
      (*one)[0].compress(VectorOperation::insert);
    const bool has_changed = Signorini::spread_fluids(elasticity,
                                                      state.displacement,
                                                      {points.total_force(pressure, pressure),
                                                       points.total_force(touching, touching),
                                                       points.total_force(tied, tied)},
                                                      spread);
    if (has_changed && scene.contact.chosen().pressure_shift() == PressureShift::normal_stress)
      configuration_solver.find_contact(true);
    return has_changed;
  }



  // Before the first solution nothing is wet: surfaces first come into contact.
  template <int dim>
  void
  Equilibrium<dim>::start_fluids()
  {
    if (!has_fluids(elasticity.loads()))
      return;
    const bool is_first =
      Utilities::MPI::max(state.contact.empty() ? 0 : 1, elasticity.mesh().communicator()) == 0;
    if (is_first)
      Signorini::spread_fluids(elasticity, state.displacement, {}, FluidSpread::nowhere);
    else
      spread_fluids(FluidSpread::open_faces);
  }



  // Each solution decides which bonds fail next, and where fluids go. Ends since there are finitely
  // many points and faces: failed bonds stay so, and wet faces too, but that those which have
  // closed are left once. Collective.
  template <int dim>
  bool
  Equilibrium<dim>::solve_while_state_changes(const double t, const double tolerance)
  {
    const bool with_fluids = has_fluids(elasticity.loads());
    bool       may_dry     = true;
    for (;;)
      {
        const bool bonds_fail = configuration_solver.break_bonds();
        bool has_spread = !bonds_fail && with_fluids && spread_fluids(FluidSpread::next_faces);
        if (!bonds_fail && !has_spread && with_fluids && may_dry)
          {
            may_dry    = false;
            has_spread = spread_fluids(FluidSpread::without_closed_faces);
          }
        if (!bonds_fail && !has_spread)
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
