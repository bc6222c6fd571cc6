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
  /// The bounding box of points on all ranks.
  template <int dim>
  class Extent
  {
  public:
    /// Extend the box.
    /// @param p a point on this rank
    void
    add(const dealii::Tensor<1, dim> &p)
    {
      for (unsigned int d = 0; d < dim; ++d)
        {
          bounds[d]       = std::max(bounds[d], p[d]);
          bounds[dim + d] = std::max(bounds[dim + d], -p[d]);
        }
    }

    /// @return the box of the points of all ranks; inverted if there are no points, so that it has
    /// no neighbours. Collective.
    /// @param comm the ranks
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
    // Maxima of x and of -x, so that one reduction yields both ends.
    std::vector<double> bounds = std::vector<double>(2 * dim, -std::numeric_limits<double>::max());
  };

  /// @return the distance of a point from a box; zero inside.
  /// @param x the point
  /// @param box the box
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
