// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/mesh_file.h"

#include <deal.II/base/bounding_box.h>
#include <deal.II/grid/tria_description.h>

namespace Signorini
{
  /// Cells of a mesh file that are connected by nodes, and with no others.
  struct Piece
  {
    std::string               name;     ///< the element set that is just this piece, or pieceN
    bool                      is_named; ///< by the file
    std::vector<unsigned int> elements; ///< indices, in order
    dealii::BoundingBox<3>    box;      ///< of the nodes
  };

  /// "NAME (12 cells from (0 0 0) to (1 1 1))"
  std::string
  description(const Piece &piece);

  /// The pieces of all cells of dimension `dim`, in the order of their first elements.
  /// @param wanted the elements that count; empty: all
  std::vector<Piece>
  pieces_of(const MeshFile &file, unsigned int dim, const std::vector<bool> &wanted = {});

  /// Let pieces that have no element set be groups of their own, so that they are parts: piece1 and
  /// so on. Nothing if all cells are connected.
  void
  add_pieces(MeshFile &file, unsigned int dim);

  /// For each cell the number of its piece, from 0 in the order of first cells.
  template <int dim>
  std::vector<unsigned int>
  pieces_of(const std::vector<dealii::CellData<dim>> &cells, unsigned int n_vertices);
} // namespace Signorini
