// SPDX-License-Identifier: Apache-2.0
#include "contact/interface/surface_steps.h"

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// True if a projection coincides with a master node: there one shape function is one and all
    /// others are zero.
    template <int dim>
    bool
    is_at_node(const MasterProjection<dim> &master_point)
    {
      double squares = 0;
      for (const NodeShapeFunction<dim> &function : master_point.functions)
        squares += function.value * function.value;
      return squares > 0.95;
    }
  } // namespace



  template <int dim>
  void
  compare(const Elasticity<dim>               &elasticity,
          const BoundaryFaces<dim>            &slave,
          const std::vector<PairedPoint<dim>> &paired,
          const bool                           is_obstacle,
          ContactSurface<dim>                 &surface)
  {
    const MPI_Comm comm = elasticity.mesh().communicator();
    // Area-weighted means over the paired points of all ranks; of the ratios of moduli and sizes
    // geometric means, so that exchanging the sides inverts them.
    std::vector<double> sums(5, 0.); // area, size, area off nodes, logarithms of the ratios
    for (const PairedPoint<dim> &point : paired)
      {
        const double size = slave.patches[point.face].diameter();
        sums[0] += point.weight;
        sums[1] += point.weight * size;
        if (is_obstacle)
          continue;
        sums[2] += is_at_node(point.master_point) ? 0. : point.weight;
        sums[3] += point.weight *
                   std::log(slave.modulus(elasticity, point.face) / point.master_point.modulus);
        sums[4] += point.weight * std::log(size / point.master_point.size);
      }
    // Collective.
    Utilities::MPI::sum(sums, comm, sums);
    if (sums[0] == 0)
      return;
    surface.face_size          = sums[1] / sums[0];
    surface.non_matching_share = sums[2] / sums[0];
    surface.sides              = {std::exp(sums[3] / sums[0]), std::exp(sums[4] / sums[0])};
  }



#define INSTANTIATE(dim)                                                                           \
  template void compare(const Elasticity<dim> &,                                                   \
                        const BoundaryFaces<dim> &,                                                \
                        const std::vector<PairedPoint<dim>> &,                                     \
                        bool,                                                                      \
                        ContactSurface<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
