// SPDX-License-Identifier: Apache-2.0
#include "driver/equilibrium.h"
#include <signorini/solid/rigid_pose.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  // Sampled at quarters of the step. The largest values are those at 16 times of the history.
  template <int dim>
  double
  Equilibrium<dim>::turn_of_loads(const double from, const double to)
  {
    const auto at = [this](const double t) {
      elasticity.set_time(t);
      LA::Vector prescribed = elasticity.zero_vector();
      elasticity.distribute(prescribed);
      return std::array<LA::Vector, 2>{{prescribed, elasticity.load()}};
    };
    if (largest_loads[0] == 0 && largest_loads[1] == 0)
      {
        constexpr unsigned int n = 16;
        for (unsigned int i = 0; i <= n; ++i)
          {
            const auto now = at(scene.load_steps.end_time * i / n);
            for (unsigned int k = 0; k < 2; ++k)
              largest_loads[k] = std::max(largest_loads[k], now[k].linfty_norm());
          }
      }
    const auto first = at(from), last = at(to);
    double     result = 0;
    for (const double share : {0.25, 0.5, 0.75})
      {
        auto between = at(from + share * (to - from));
        for (unsigned int k = 0; k < 2; ++k)
          {
            between[k].add(share - 1, first[k], -share, last[k]);
            if (largest_loads[k] > 0)
              result = std::max(result, between[k].linfty_norm() / largest_loads[k]);
          }
      }
    return result;
  }



  // Free rotations are not known before the load step is solved. With the reference geometry, slip
  // is that of the points in contact, whatever the turn.
  template <int dim>
  double
  Equilibrium<dim>::turn_of_obstacles(const double t)
  {
    if (!my_uses_current_geometry && scene.contact.geometry != ContactGeometry::updated &&
        !elasticity.is_finite_strain())
      return 0;
    const std::vector<double> before = elasticity.rigid_motion(state.displacement);
    const double              now    = elasticity.time();
    LA::Vector                u      = state.displacement;
    elasticity.set_time(t);
    elasticity.distribute(u);
    const std::vector<double> after = elasticity.rigid_motion(u);
    elasticity.set_time(now);
    constexpr unsigned int n      = RigidPose<dim>::n_dofs;
    double                 result = 0;
    for (unsigned int first = 0; first < after.size(); first += n)
      {
        double square = 0;
        for (unsigned int i = first + dim; i < first + n; ++i)
          square += (after[i] - before[i]) * (after[i] - before[i]);
        result = std::max(result, std::sqrt(square) / elasticity.rotation_length_scale());
      }
    return result;
  }



  template double
  Equilibrium<2>::turn_of_loads(double, double);
  template double
  Equilibrium<3>::turn_of_loads(double, double);
  template double
  Equilibrium<2>::turn_of_obstacles(double);
  template double
  Equilibrium<3>::turn_of_obstacles(double);
} // namespace Signorini
