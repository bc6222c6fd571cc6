// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "matrix_free/cell_kernel.h"

#include <boost/align/aligned_allocator.hpp>

namespace Signorini
{
  /// Cells in batches of as many as a processor's vectors have places, with what a kernel keeps of
  /// them: a number of each cell stands beside that of the next one. Affine cells come first: they
  /// are content with the geometry of one point. What is left of a batch is filled by its last cell
  /// once more, with no weight.
  template <typename Number>
  class Batches
  {
  public:
    Batches(const KernelCells &cells, unsigned int width);

    std::size_t
    size() const
    {
      return n_batches;
    }

    bool
    is_affine(const std::size_t batch) const
    {
      return batch < n_affine;
    }

    /// [node][cell]: see KernelCells::nodes
    const std::uint32_t *
    nodes(const std::size_t batch) const
    {
      return &my_nodes[batch * n_nodes * width];
    }

    /// [lambda, mu][cell]
    const Number *
    material(const std::size_t batch) const
    {
      return &my_material[batch * 2 * width];
    }

    /// One, or zero for cells that only fill.
    const Number *
    fills(const std::size_t batch) const
    {
      return &my_fills[batch * width];
    }

    /// [ten numbers][cell]: derivatives of the unit coordinates by place, [unit coordinate][place],
    /// then the volume of the cell (affine ones) or the weight of the point q.
    const Number *
    geometry(const std::size_t batch, const unsigned int q) const
    {
      return &my_geometry[first_of(batch, q)];
    }

    Number *
    geometry(const std::size_t batch, const unsigned int q)
    {
      return &my_geometry[first_of(batch, q)];
    }

    /// A component of the place of a node, from the first node of its cell, so that there is no
    /// cancellation in single precision.
    Number
    point(const std::size_t  batch,
          const unsigned int cell,
          const unsigned int node,
          const unsigned int component) const
    {
      const double *first =
        &my_cells->points[std::size_t(order[batch * width + cell]) * 3 * n_nodes];
      return Number(first[3 * node + component] - first[component]);
    }

    /// Geometry is set.
    void
    drop_points()
    {
      my_cells = nullptr;
      order.clear();
      order.shrink_to_fit();
    }

    std::size_t
    memory_consumption() const;

  private:
    std::size_t
    first_of(const std::size_t batch, const unsigned int q) const
    {
      constexpr std::size_t numbers = 10;
      const std::size_t     before =
        is_affine(batch) ? batch : n_affine + (batch - n_affine) * n_nodes + q;
      return before * numbers * width;
    }

    /// Vectors of the processor are loaded from there.
    using Array = std::vector<Number, boost::alignment::aligned_allocator<Number, 64>>;

    const KernelCells         *my_cells;
    const std::size_t          width, n_nodes;
    std::size_t                n_batches = 0, n_affine = 0;
    std::vector<std::uint32_t> order; ///< the cell at each place
    std::vector<std::uint32_t> my_nodes;
    Array                      my_geometry, my_material, my_fills;
  };
} // namespace Signorini
