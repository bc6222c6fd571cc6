// SPDX-License-Identifier: Apache-2.0
#include "accuracy/p_refinement.h"

#include <deal.II/fe/fe_tools.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  // Compares the numbers of degrees of freedom that both degrees need for the target, see the
  // header.
  template <int dim>
  std::vector<unsigned int>
  bodies_to_p_refine(const Mesh<dim>           &mesh,
                     const std::vector<double> &indicators,
                     const std::vector<bool>   &is_open,
                     const double               excess_error)
  {
    constexpr double price      = 2;   // of a degree of freedom of degree 2
    constexpr double negligible = 0.1; // for bodies that are exact enough as they are
    if (std::pow(excess_error, dim / 2.) <= price * std::pow(2., dim))
      return {};
    std::vector<double> sums(mesh.n_bodies(), 0.);
    for (const auto &cell : mesh.triangulation().active_cell_iterators())
      if (cell->is_locally_owned())
        sums[mesh.body(cell)] += indicators[cell->active_cell_index()];
    Utilities::MPI::sum(sums, mesh.communicator(), sums);
    std::vector<unsigned int> result;
    for (unsigned int body = 0; body < sums.size(); ++body)
      if (is_open[body] && sums[body] > negligible)
        result.push_back(body);
    return result;
  }



  template <int dim>
  double
  growth_of_p_refinement(const Mesh<dim> &mesh, const std::vector<unsigned int> &bodies)
  {
    unsigned int n = 0;
    for (const auto &cell : mesh.triangulation().active_cell_iterators())
      if (cell->is_locally_owned())
        n += std::count(bodies.begin(), bodies.end(), mesh.body(cell));
    const double share = Utilities::MPI::sum(double(n), mesh.communicator()) /
                         mesh.triangulation().n_global_active_cells();
    return 1 + share * (std::pow(2., dim) - 1);
  }



  // Interpolation is exact, since the spaces are nested.
  template <int dim>
  LA::Vector
  p_refined(const Elasticity<dim> &elasticity,
            const LA::Vector      &displacement,
            const Elasticity<dim> &richer)
  {
    const LA::Vector ghosted = elasticity.with_ghosts(displacement);
    LA::Vector       part = richer.zero_mesh_vector(), result = richer.zero_vector();
    FETools::interpolate(
      elasticity.dof_handler(), ghosted, richer.dof_handler(), richer.hanging_nodes(), part);
    richer.set_mesh_part(part, result);
    richer.set_rigid_motion(elasticity.rigid_motion(displacement), result);
    return result;
  }



#define INSTANTIATE(dim)                                                                            \
  template std::vector<unsigned int> bodies_to_p_refine(const Mesh<dim> &,                          \
                                                        const std::vector<double> &,                \
                                                        const std::vector<bool> &,                  \
                                                        double);                                    \
  template double     growth_of_p_refinement(const Mesh<dim> &, const std::vector<unsigned int> &); \
  template LA::Vector p_refined(const Elasticity<dim> &,                                            \
                                const LA::Vector &,                                                 \
                                const Elasticity<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
