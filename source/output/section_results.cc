// SPDX-License-Identifier: Apache-2.0
#include "fields/cross_sections.h"
#include "output/results.h"
#include <signorini/solid/rigid_body.h>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  Json
  section_results(const Snapshot<dim> &s, const std::vector<CrossSection<dim>> &sections)
  {
    Json       result = Json::object();
    const auto forces = section_forces(s, sections);
    for (unsigned int i = 0; i < sections.size(); ++i)
      {
        const Tensor<1, dim> &normal = sections[i].normal;
        Json                  moment;
        for (unsigned int d = 0; d < RigidBody<dim>::n_rotations; ++d)
          moment.push_back(forces[i].resultant.moment[d]);
        const Tensor<1, dim> &force = forces[i].resultant.force;
        result[sections[i].name]    = {{"force", list(force)},
                                       {"normal_force", force * normal / normal.norm()},
                                       {"moment", moment},
                                       {"uncertainty", forces[i].uncertainty}};
      }
    return result;
  }



  template Json
  section_results(const Snapshot<2> &, const std::vector<CrossSection<2>> &);
  template Json
  section_results(const Snapshot<3> &, const std::vector<CrossSection<3>> &);
} // namespace Signorini
