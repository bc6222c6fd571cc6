// SPDX-License-Identifier: Apache-2.0
#include "driver/scene_setup.h"
#include "driver/simulation.h"
#include <signorini/driver/solve.h>
#include <signorini/parameters/raw.h>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The contact values of this rank at the end of a load step.
    template <int dim>
    LoadStepResult<dim>
    result_of(const Snapshot<dim> &now)
    {
      LoadStepResult<dim> result{now.step, now.time, {}};
      const GapOperator  &points = now.contact;
      const IndexSet      rows   = points.weight.locally_owned_elements();
      auto                row    = rows.begin();
      for (const unsigned int pair : points.origin.pair)
        {
          const auto        i = *row++;
          ContactValue<dim> one;
          one.pair = now.pairs[pair].name;
          for (unsigned int d = 0; d < dim; ++d)
            {
              one.position[d] = points.geometry.position[d](i);
              one.normal[d]   = points.geometry.normal[d](i);
            }
          // The normal of a node is a mean, which is shorter than one on curved surfaces.
          if (one.normal.norm() > 0)
            one.normal /= one.normal.norm();
          one.area      = points.weight(i);
          one.gap       = now.gap(i);
          one.pressure  = now.pressure(i);
          one.is_active = now.active(i) > 0;
          result.contact.push_back(one);
        }
      return result;
    }
  } // namespace



  template <int dim>
  Scene<dim>
  scene_of(const std::vector<std::string> &assignments,
           const std::string              &name,
           const std::string              &folder)
  {
    RawSection raw;
    for (const std::string &assignment : assignments)
      override_value(raw, assignment);
    if (const RawSection::Value *dimension = raw.find_value("Dimension");
        dimension && dimension->text != std::to_string(dim))
      throw SceneError("Dimension = " + dimension->text +
                       ": the scene is made as one of dimension " + std::to_string(dim) +
                       "; leave Dimension out");
    override_value(raw, "Dimension=" + std::to_string(dim));
    return read_scene<dim>(raw, name, folder);
  }



  template <int dim>
  ExitCode
  solve(const Scene<dim>                                       &scene,
        const MPI_Comm                                          comm,
        std::ostream                                           &out,
        const std::function<void(const LoadStepResult<dim> &)> &after_step)
  {
    scene.check();
    Simulation<dim> simulation(scene, comm, out, RunOrigin::program);
    if (after_step)
      simulation.after_step = [&](const Snapshot<dim> &now) { after_step(result_of(now)); };
    return simulation.run();
  }



#define INSTANTIATE(dim)                                                                           \
  template Scene<dim> scene_of(const std::vector<std::string> &,                                   \
                               const std::string &,                                                \
                               const std::string &);                                               \
  template ExitCode   solve(const Scene<dim> &,                                                    \
                            MPI_Comm,                                                              \
                            std::ostream &,                                                        \
                            const std::function<void(const LoadStepResult<dim> &)> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
