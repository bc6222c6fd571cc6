// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/point.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace Signorini
{
  /// The box around points on all ranks.
  template <int dim>
  class Extent
  {
  public:
    void
    add(const dealii::Tensor<1, dim> &p)
    {
      for (unsigned int d = 0; d < dim; ++d)
        {
          bounds[d]       = std::max(bounds[d], p[d]);
          bounds[dim + d] = std::max(bounds[dim + d], -p[d]);
        }
    }

    /// Collective. Inside out if there are no points: then nothing is its neighbour.
    dealii::BoundingBox<dim>
    reduce_over_ranks(const MPI_Comm comm) const
    {
      std::vector<double> all(2 * dim);
      dealii::Utilities::MPI::max(bounds, comm, all);
      dealii::Point<dim> low, high;
      for (unsigned int d = 0; d < dim; ++d)
        {
          high[d] = all[d];
          low[d]  = -all[dim + d];
        }
      return dealii::BoundingBox<dim>({low, high});
    }

  private:
    // Of x and of -x, so that one reduction serves both ends.
    std::vector<double> bounds = std::vector<double>(2 * dim, -std::numeric_limits<double>::max());
  };

  /// Distance of a point to a box, zero inside.
  template <int dim>
  double
  distance(const dealii::Point<dim> &x, const dealii::BoundingBox<dim> &box)
  {
    const auto &[lower, upper] = box.get_boundary_points();
    double square              = 0;
    for (unsigned int d = 0; d < dim; ++d)
      {
        const double outside = std::max({lower[d] - x[d], 0., x[d] - upper[d]});
        square += outside * outside;
      }
    return std::sqrt(square);
  }
} // namespace Signorini
