// SPDX-License-Identifier: Apache-2.0
#include "matrix_free/batches.h"

#include <algorithm>

namespace Signorini
{
  // Interleave the tangents of the cells of a batch: [batch][point][number][cell]. The last batch
  // is filled up with copies of the last cell, with zero tangents.
  TangentBatches::TangentBatches(const KernelCells &cells, const std::size_t width)
    : width(width)
    , n_nodes(cells.nodes_per_cell())
    , n_points(cells.tangents.size() / cells.size())
    , n_batches((cells.size() + width - 1) / width)
    , my_nodes(n_batches * n_nodes * width)
    , my_tangents(n_batches * n_points * n_tangent_numbers * width, 0.f)
  {
    // Copies have nodes, so that they read and write valid places, but no tangents.
    for (std::size_t slot = 0; slot < n_batches * width; ++slot)
      {
        const std::size_t cell  = std::min<std::size_t>(slot, cells.size() - 1),
                          batch = slot / width, w = slot % width;
        for (std::size_t i = 0; i < n_nodes; ++i)
          my_nodes[(batch * n_nodes + i) * width + w] = cells.nodes[cell * n_nodes + i];
        if (cell == slot)
          for (std::size_t q = 0; q < n_points; ++q)
            for (std::size_t k = 0; k < n_tangent_numbers; ++k)
              my_tangents[((batch * n_points + q) * n_tangent_numbers + k) * width + w] =
                cells.tangents[cell * n_points + q][k];
      }
  }
} // namespace Signorini
