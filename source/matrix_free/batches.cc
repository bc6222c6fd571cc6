// SPDX-License-Identifier: Apache-2.0
#include "matrix_free/batches.h"

#include "geometry/simplex_nodes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace Signorini
{
  namespace
  {
    /// The places of the nodes in the reference cell, in halves of its size for degree 2: of
    /// hexahedra a lattice, of tetrahedra vertices and middles of edges.
    std::vector<std::array<unsigned int, 3>>
    reference_nodes(const KernelCells &cells)
    {
      std::vector<std::array<unsigned int, 3>> result(cells.nodes_per_cell());
      if (cells.are_tetrahedra)
        {
          // Vertex 0 is the origin, the others are on the axes.
          for (unsigned int a = 1; a < 4; ++a)
            result[a][a - 1] = cells.degree;
          for (unsigned int a = 1; cells.degree == 2 && a < 4; ++a)
            for (unsigned int b = 0; b < a; ++b)
              for (const unsigned int vertex : {a, b})
                if (vertex > 0)
                  result[node_between<3>(a, b)][vertex - 1] = 1;
          return result;
        }
      const unsigned int n = cells.degree + 1;
      for (unsigned int i = 0; i < result.size(); ++i)
        result[i] = {{i % n, i / n % n, i / (n * n)}};
      return result;
    }

    /// True if the mapping of a cell is affine: each node is where the three edges at the first
    /// node place it, to 1e-10 of the size of the cell.
    /// @param nodes reference_nodes()
    bool
    is_affine_cell(const double                                   *points,
                   const std::vector<std::array<unsigned int, 3>> &nodes,
                   const unsigned int                              degree)
    {
      constexpr double rounding = 1e-10; // of the cell's size
      // The ends of the three edges at the first node span the affine map. All nodes, also the
      // inner ones of degree 2, must be where it maps their places.
      const double *far[3] = {};
      for (unsigned int i = 0; i < nodes.size(); ++i)
        for (unsigned int d = 0; d < 3; ++d)
          if (nodes[i][d] == degree && nodes[i][(d + 1) % 3] == 0 && nodes[i][(d + 2) % 3] == 0)
            far[d] = points + 3 * i;
      double size = 0;
      for (const double *corner : far)
        for (unsigned int c = 0; c < 3; ++c)
          size = std::max(size, std::abs(corner[c] - points[c]));
      for (unsigned int i = 0; i < nodes.size(); ++i)
        for (unsigned int c = 0; c < 3; ++c)
          {
            double extrapolated_point = points[c];
            for (unsigned int d = 0; d < 3; ++d)
              extrapolated_point += (far[d][c] - points[c]) * nodes[i][d] / degree;
            if (std::abs(points[3 * i + c] - extrapolated_point) > rounding * size)
              return false;
          }
      return true;
    }
  } // namespace



  template <typename Number>
  Batches<Number>::Batches(const KernelCells &cells, const unsigned int width)
    : my_cells(&cells)
    , width(width)
    , n_nodes(cells.nodes_per_cell())
    , n_points(cells.points_per_cell())
  {
    // Sort cells into affine batches and others; the last batch of each kind is filled up with
    // copies of its last cell, which get no weight.
    const auto        reference = reference_nodes(cells);
    std::vector<bool> is_real;
    const auto        append = [&](const bool affine) {
      for (unsigned int cell = 0; cell < cells.size(); ++cell)
        if (is_affine_cell(&cells.points[std::size_t(cell) * 3 * n_nodes],
                           reference,
                           cells.degree) == affine)
          {
            order.push_back(cell);
            is_real.push_back(true);
          }
      while (order.size() % width != 0)
        {
          order.push_back(order.back());
          is_real.push_back(false);
        }
      // A vector register has one cell in each lane. Without copies in the last batch, kernels
      // would need a special case for its empty lanes.
      return order.size() / width;
    };
    n_affine  = append(true);
    n_batches = append(false);

    my_nodes.resize(n_batches * n_nodes * width);
    my_material.resize(n_batches * 2 * width);
    my_fills.resize(n_batches * width);
    if (n_batches == 0)
      return;
    // Affine batches have ten numbers a cell, all others ten for each integration point. The
    // offsets follow from first_of(), so that the end of the last entry is the size.
    my_geometry.resize(n_batches == n_affine ? first_of(n_affine - 1, 0) + 10 * width :
                                               first_of(n_batches - 1, n_points - 1) + 10 * width);
    // Interleave the data of the cells of a batch: lane w of batch b has the cell in slot b W + w.
    for (std::size_t slot = 0; slot < order.size(); ++slot)
      {
        const std::size_t cell = order[slot], batch = slot / width, w = slot % width;
        my_fills[slot]                             = is_real[slot] ? 1 : 0;
        my_material[batch * 2 * width + w]         = cells.lambda[cell];
        my_material[batch * 2 * width + width + w] = cells.mu[cell];
        for (std::size_t i = 0; i < n_nodes; ++i)
          my_nodes[(batch * n_nodes + i) * width + w] = cells.nodes[cell * n_nodes + i];
      }
  }



  template <typename Number>
  std::size_t
  Batches<Number>::memory_consumption() const
  {
    return my_nodes.size() * sizeof(std::uint32_t) +
           (my_geometry.size() + my_material.size() + my_fills.size()) * sizeof(Number);
  }



  template class Batches<float>;
  template class Batches<double>;
} // namespace Signorini
