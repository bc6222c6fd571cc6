// SPDX-License-Identifier: Apache-2.0
#include "output/results.h"
#include "solid/fluid_spread.h"

namespace Signorini
{
  template <int dim>
  Json
  fluid_results(const Snapshot<dim> &s)
  {
    Json result = Json::object();
    for (const Load<dim> &load : s.elasticity.loads())
      if (load.wet)
        {
          const WetArea area = wet_area(s.elasticity, load);
          result[load.name]  = {{"wet_area", area.wet},
                                {"area", area.total},
                                {"force_at_edge", area.at_edge}};
        }
    return result;
  }



  template Json
  fluid_results(const Snapshot<2> &);
  template Json
  fluid_results(const Snapshot<3> &);
} // namespace Signorini
