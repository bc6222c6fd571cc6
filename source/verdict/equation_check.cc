// SPDX-License-Identifier: Apache-2.0
#include "solid/cell_nodes.h"
#include "verdict/checks.h"

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  // Cells that are refined have nodes between those of the file. So have cells of degree two with
  // several nodes of equations, all of which are corners.
  template <int dim>
  std::vector<CheckResult>
  check_equations(const Snapshot<dim> &now)
  {
    const Elasticity<dim>       &elasticity = now.elasticity;
    const ConstrainedNodes<dim> &nodes      = elasticity.nodes_of_equations();
    if (nodes.empty())
      return {};
    std::vector<types::global_dof_index> indices;
    unsigned int                         n = 0;
    for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          read_indices<dim>(cell, indices);
          const unsigned int n_here =
            std::count_if(indices.begin(), indices.end(), [&](const auto i) {
              return nodes.count(i) > 0;
            });
          unsigned int n_corners = 0;
          for (const unsigned int v : cell->vertex_indices())
            n_corners += nodes.count(cell->vertex_dof_index(v, 0, cell->active_fe_index()));
          n += (n_here > 0 && cell->level() > 0) ||
               (cell->get_fe().degree > 1 && n_corners > 1 && n_here == n_corners);
        }
    CheckResult result;
    result.check   = "cells with nodes between those of equations";
    result.value   = Utilities::MPI::sum(n, elasticity.mesh().communicator());
    result.limit   = 0;
    result.outcome = result.value == 0 ? Outcome::passed : Outcome::warned;
    result.message =
      "the constraint equations hold at the nodes of the mesh file alone; between them, "
      "on refined cells and those of degree 2, displacements do not follow them";
    result.advice = "use the mesh as it is (Mesh/Refinements = 0, and Degree = 1 for first-order "
                    "meshes), or tie surfaces (Law = tied, Master shift)";
    return {result};
  }



  template std::vector<CheckResult>
  check_equations(const Snapshot<2> &);
  template std::vector<CheckResult>
  check_equations(const Snapshot<3> &);
} // namespace Signorini
