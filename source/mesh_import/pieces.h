// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/mesh_file.h"

#include <deal.II/base/bounding_box.h>
#include <deal.II/grid/tria_description.h>

namespace Signorini
{
  /// A connected component of a mesh: cells that are connected by nodes with each other, and with
  /// no others.
  struct Piece
  {
    /// Name of the group whose cells are just those of this piece, or "piece" with a number.
    std::string name;
    /// Whether the name is from the file.
    bool is_named;
    /// Indices of the elements, in ascending order.
    std::vector<unsigned int> elements;
    /// Bounding box of the nodes.
    dealii::BoundingBox<3> box;
  };

  /// @return a text for messages: "NAME (12 cells from (0 0 0) to (1 1 1))".
  /// @param piece the piece
  std::string
  description(const Piece &piece);

  /// @return the pieces of all cells of a dimension, in the order of their first elements.
  /// @param file the mesh file
  /// @param dim the dimension of the cells
  /// @param wanted for each element whether it is considered; empty: all are
  std::vector<Piece>
  pieces_of(const MeshFile &file, unsigned int dim, const std::vector<bool> &wanted = {});

  /// Create groups for pieces that no group of the file describes, called piece1 and so on, so that
  /// they can be parts of the scene. Nothing is done if all cells are connected.
  /// @param file the mesh file, which is changed
  /// @param dim the dimension of the cells
  void
  add_pieces(MeshFile &file, unsigned int dim);

  /// @return for each cell the number of its piece, from 0 in the order of first cells.
  /// @param cells the mesh
  /// @param n_vertices number of vertices to which the cells refer
  template <int dim>
  std::vector<unsigned int>
  pieces_of(const std::vector<dealii::CellData<dim>> &cells, unsigned int n_vertices);

  /// @return the other parts of a file with whose cells those of a part share faces.
  /// @param file the mesh
  /// @param dim 2 or 3
  /// @param part name of the group; empty: there are no others
  std::vector<std::string>
  neighbours_of(const MeshFile &file, unsigned int dim, const std::string &part);
} // namespace Signorini
