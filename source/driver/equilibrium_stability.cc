// SPDX-License-Identifier: Apache-2.0
// The part of the equilibrium that tells whether its path is stable: jumps, indefinite tangents and
// critical friction.
#include "driver/equilibrium.h"

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  // Ratio of the displacement rate of this load step to that of the last one, if it indicates a
  // snap-through: more than three times as fast as before, not explained by faster prescribed
  // motions, and with an indefinite tangent on the path between both. Otherwise 0.
  template <int dim>
  double
  Equilibrium<dim>::speed_ratio_since(const State &before)
  {
    // Ratio of displacement rates above which a step may be a jump.
    constexpr double fast     = 3;
    const double     duration = state.time - before.time;
    // The same time was solved on another mesh.
    if (duration == 0)
      return 0;
    LA::Vector way = state.displacement;
    way -= before.displacement;
    LA::Vector prescribed_increment = before.displacement;
    elasticity.distribute(prescribed_increment);
    prescribed_increment -= before.displacement;
    // A displacement rate that supports and obstacles prescribe is not a snap-through: it is
    // compared with the ratio of prescribed rates.
    const double speed = way.l2_norm() / duration,
                 drive = prescribed_increment.l2_norm() / duration,
                 pushed =
                   last_prescribed_speed > 0 ? std::max(1., drive / last_prescribed_speed) : 1,
                 times    = last_speed > 0 && (drive == 0 || last_prescribed_speed > 0) ?
                              speed / (last_speed * pushed) :
                              0;
    last_speed            = speed;
    last_prescribed_speed = drive;
    if (times <= fast)
      return 0;
    return is_indefinite_on_path_from(before) ? times : 0;
  }



  // Test the tangent at a quarter, half and three quarters of the straight line.
  template <int dim>
  bool
  Equilibrium<dim>::is_indefinite_on_path_from(const State &before)
  {
    LA::Vector way = state.displacement;
    way -= before.displacement;
    if (way.linfty_norm() == 0)
      return false;
    for (const double share : {0.25, 0.5, 0.75})
      {
        LA::Vector between = before.displacement;
        between.add(share, way);
        if (configuration_solver.tangent_is_indefinite(between))
          return true;
      }
    return false;
  }



  // It costs about as many iterations as a Newton step or two, and changes little from load step to
  // load step.
  template <int dim>
  void
  Equilibrium<dim>::add_critical_friction()
  {
    constexpr double large = 0.5;
    const bool is_small    = last_friction_over_critical > 0 && last_friction_over_critical < large;
    if (is_small && state.time < scene.load_steps.ends().back())
      return;
    last_friction_over_critical      = configuration_solver.friction_over_critical();
    my_report.friction_over_critical = last_friction_over_critical;
  }



#define INSTANTIATE(dim)                                                                           \
  template void   Equilibrium<dim>::add_critical_friction();                                       \
  template double Equilibrium<dim>::speed_ratio_since(const State &);                              \
  template bool   Equilibrium<dim>::is_indefinite_on_path_from(const State &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
