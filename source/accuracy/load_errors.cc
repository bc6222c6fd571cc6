// SPDX-License-Identifier: Apache-2.0
#include "accuracy/error_parts.h"
#include "solid/kernel.h"

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Three points more in each direction show what a formula does between the usual ones.
    constexpr unsigned int more_points = 3;

    /// @return whether a load is a formula of the place, which no rule integrates exactly.
    template <int dim>
    bool
    depends_on_place(const Load<dim> &load)
    {
      return !load.axes.are_global() || load.traction.depends_on_place() ||
             load.pressure.depends_on_place() || load.body_force.depends_on_place();
    }
  } // namespace



  // The work of both load vectors with the dual displacement, cell by cell, so that no constraints
  // need to be condensed: the dual displacement satisfies them.
  template <int dim>
  std::vector<std::vector<double>>
  load_errors(const Elasticity<dim> &elasticity, const std::vector<DualField> &duals)
  {
    const unsigned int               n_cells = elasticity.mesh().triangulation().n_active_cells();
    std::vector<std::vector<double>> result(duals.size(), std::vector<double>(n_cells, 0.));
    const std::vector<Load<dim>>    &loads = elasticity.loads();
    if (std::none_of(loads.begin(), loads.end(), depends_on_place<dim>))
      return result;
    std::vector<LA::Vector> z;
    for (const DualField &dual : duals)
      z.push_back(elasticity.with_ghosts(dual.displacement));
    const auto kernel = [&](const unsigned int beyond) {
      return LoadKernel<dim>(elasticity.mesh(),
                             elasticity.finite_elements(),
                             elasticity.model(),
                             loads,
                             elasticity.time(),
                             beyond);
    };
    auto           usual = kernel(0), finer = kernel(more_points);
    Vector<double> load, finer_load, values;
    for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned() && finer.assemble(cell, finer_load))
        {
          usual.assemble(cell, load);
          finer_load -= load;
          values.reinit(finer_load.size());
          for (unsigned int i = 0; i < duals.size(); ++i)
            {
              cell->get_dof_values(z[i], values);
              result[i][cell->active_cell_index()] = values * finer_load;
            }
        }
    return result;
  }



  template std::vector<std::vector<double>>
  load_errors(const Elasticity<2> &, const std::vector<DualField> &);
  template std::vector<std::vector<double>>
  load_errors(const Elasticity<3> &, const std::vector<DualField> &);
} // namespace Signorini
