// SPDX-License-Identifier: Apache-2.0
#include "driver/load_path.h"

#include "fields/friction_fields.h"
#include "fields/recovered_pressure.h"

namespace Signorini
{
  template <int dim>
  std::vector<LA::Vector>
  all_tangential_tractions(const Snapshot<dim> &snapshot)
  {
    std::vector<LA::Vector> result;
    for (unsigned int pair = 0; pair < snapshot.pairs.size(); ++pair)
      for (const LA::Vector &component : tangential_traction(snapshot, pair))
        result.push_back(component);
    return result;
  }



  template <int dim>
  bool
  are_negligible(const std::vector<LA::Vector> &tractions, const Snapshot<dim> &snapshot)
  {
    constexpr double none       = 1e-6;
    double           tangential = 0, normal = 0;
    for (const LA::Vector &component : tractions)
      tangential += component.l1_norm();
    for (unsigned int pair = 0; pair < snapshot.pairs.size(); ++pair)
      normal += recovered_pressure(snapshot, pair).l1_norm();
    return tangential <= none * normal;
  }



  double
  path_error(const std::vector<LA::Vector> &coarse, const std::vector<LA::Vector> &fine)
  {
    double difference = 0, size = 0;
    for (unsigned int k = 0; k < fine.size(); ++k)
      {
        LA::Vector change = fine[k];
        change -= coarse[k];
        difference += change.l1_norm();
        size += fine[k].l1_norm();
      }
    return size > 0 ? difference / size : 0.;
  }



  template std::vector<LA::Vector>
  all_tangential_tractions(const Snapshot<2> &);
  template std::vector<LA::Vector>
  all_tangential_tractions(const Snapshot<3> &);
  template bool
  are_negligible(const std::vector<LA::Vector> &, const Snapshot<2> &);
  template bool
  are_negligible(const std::vector<LA::Vector> &, const Snapshot<3> &);
} // namespace Signorini
