// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "matrix_free/cell_kernel.h"

#include <boost/align/aligned_allocator.hpp>

namespace Signorini
{
  /// Cells in batches of as many as a vector of the processor has lanes, with nodes, moduli and
  /// geometry: the numbers of the cells of a batch are adjacent. Affine cells come first; they
  /// store the geometry of one point. The last batch of each kind is filled up with its last cell,
  /// with zero weight.
  template <typename Number>
  class Batches
  {
  public:
    /// @param width lanes of a vector; the cells are referred to until drop_points()
    Batches(const KernelCells &cells, unsigned int width);

    /// The number of batches.
    std::size_t
    size() const
    {
      return n_batches;
    }

    /// True if all cells of the batch are affine; such batches are the first ones.
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

    /// One for each cell of a batch; zero for cells that only fill it up.
    const Number *
    fills(const std::size_t batch) const
    {
      return &my_fills[batch * width];
    }

    /// Ten numbers for each cell: [number][cell], the derivatives of the reference coordinates with
    /// respect to position, [reference coordinate][position], then det J (affine cells) or the
    /// weight of point q.
    const Number *
    geometry(const std::size_t batch, const unsigned int q) const
    {
      return &my_geometry[first_of(batch, q)];
    }

    /// The place of these numbers, to be set.
    Number *
    geometry(const std::size_t batch, const unsigned int q)
    {
      return &my_geometry[first_of(batch, q)];
    }

    /// A component of the position of a node relative to the first node of its cell, so that there
    /// is no cancellation in single precision [length].
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

    /// Release the reference to the cells after the geometry has been set.
    void
    drop_points()
    {
      my_cells = nullptr;
      order.clear();
      order.shrink_to_fit();
    }

    /// The memory of the batches [byte].
    std::size_t
    memory_consumption() const;

  private:
    std::size_t
    first_of(const std::size_t batch, const unsigned int q) const
    {
      constexpr std::size_t numbers = 10;
      const std::size_t     before =
        is_affine(batch) ? batch : n_affine + (batch - n_affine) * n_points + q;
      return before * numbers * width;
    }

    /// Arrays from which vectors of the processor are loaded, aligned to 64 bytes.
    using Array = std::vector<Number, boost::alignment::aligned_allocator<Number, 64>>;

    const KernelCells         *my_cells;
    const std::size_t          width, n_nodes, n_points;
    std::size_t                n_batches = 0, n_affine = 0;
    std::vector<std::uint32_t> order; ///< the cell at each place
    std::vector<std::uint32_t> my_nodes;
    Array                      my_geometry, my_material, my_fills;
  };

  /// Cells with tangents in batches, as Batches.
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

    /// The tangent of a point of each cell: [number][cell]; zero for cells that only fill up a
    /// batch.
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
