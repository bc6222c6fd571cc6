// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "matrix_free/cell_kernel.h"

#include <boost/align/aligned_allocator.hpp>

namespace Signorini
{
  /// Cells that have tangents, in batches as Batches are.
  class TangentBatches
  {
  public:
    TangentBatches(const KernelCells &cells, std::size_t width);

    std::size_t
    size() const
    {
      return n_batches;
    }

    /// [node][cell]: see KernelCells::nodes
    const std::uint32_t *
    nodes(const std::size_t batch) const
    {
      return &my_nodes[batch * n_nodes * width];
    }

    /// [number][cell]; zero for cells that only fill.
    const float *
    tangent(const std::size_t batch, const std::size_t point) const
    {
      return &my_tangents[(batch * n_points + point) * n_tangent_numbers * width];
    }

    std::size_t
    memory_consumption() const
    {
      return my_nodes.size() * sizeof(std::uint32_t) + my_tangents.size() * sizeof(float);
    }

  private:
    const std::size_t          width, n_nodes, n_points, n_batches;
    std::vector<std::uint32_t> my_nodes;

    /// Vectors of the processor are loaded from there.
    std::vector<float, boost::alignment::aligned_allocator<float, 64>> my_tangents;
  };
} // namespace Signorini
