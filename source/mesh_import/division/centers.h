// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/mesh_file.h"

#include <array>
#include <unordered_map>

namespace Signorini
{
  /// The nodes in the middle of edges and at the centres of faces, found by the corners around, so
  /// that neighbours share them. Those of second-order elements are in the file, others are created
  /// and appended to it. The position of such a node depends on the nodes of its edge or face
  /// alone, so that all cells there agree.
  class Centers
  {
  public:
    static constexpr unsigned int none = -1;

    /// @param file the mesh to which nodes are appended; the object refers to it
    explicit Centers(MeshFile &file)
      : file(file)
      , n_in_file(file.nodes.size())
    {}

    /// Register the nodes of second order of a cell. Throws SceneError if another cell has another
    /// node at the same edge or face, that is, if the cells are not connected there.
    /// @param cell with nodes behind its corners, or without
    void
    take(const MeshFile::Element &cell);

    /// @return the node in the middle of an edge, created if there is none.
    /// @param a,b the corners of the edge
    unsigned int
    of_edge(unsigned int a, unsigned int b);

    /// @return the node at the centre of a face, created if there is none.
    /// @param around the three or four corners of the face, in cyclic order
    unsigned int
    of_face(const MeshFile::Nodes &around);

    /// @return the node in the middle of a diagonal of a quadrilateral, which is the centre of the
    /// face if the face is curved.
    /// @param around the four corners of the face, in cyclic order
    /// @param a,b the corners that the diagonal connects
    unsigned int
    of_diagonal(const MeshFile::Nodes &around, unsigned int a, unsigned int b);

    /// Let a node be the middle of two corners, for an inner diagonal of a cell.
    /// @param a,b the corners
    /// @param node the node, which has no edge or face of its own
    void
    set_middle(unsigned int a, unsigned int b, unsigned int node)
    {
      nodes[key({a, b})] = node;
    }

    /// @return a new node inside a cell, which is not shared with others.
    /// @param corners of the cell
    /// @param place its position
    unsigned int
    of_cell(const MeshFile::Nodes &corners, const dealii::Point<3> &place);

    /// Add the created nodes to all node sets of the file that contain all its nodes around them.
    void
    complete_node_sets();

    /// Give the created nodes values in all scalar fields of the file that have none there: the
    /// mean of those at the corners around.
    void
    complete_fields();

    /// The corners of an edge, triangle or quadrilateral, sorted; unused entries are `none`.
    using Key = std::array<unsigned int, 4>;

    /// @return the key of up to four corners in any order.
    /// @param corners indices of nodes
    static Key
    key(const MeshFile::Nodes &corners);

    struct Hash
    {
      std::size_t
      operator()(const Key &key) const
      {
        std::size_t hash = 0;
        for (const unsigned int node : key)
          hash = (hash ^ node) * 0x9E3779B97F4A7C15ull;
        return hash ^ (hash >> 32);
      }
    };

  private:
    unsigned int
    add(const MeshFile::Nodes &corners, const dealii::Point<3> &place);
    bool
    is_in_file(const MeshFile::Nodes &corners) const;
    dealii::Point<3>
    center(const MeshFile::Nodes &around);
    void
    store(unsigned int node, const MeshFile::Nodes &corners);

    MeshFile                                   &file;
    const unsigned int                          n_in_file;
    std::unordered_map<Key, unsigned int, Hash> nodes;

    struct InsertedNode
    {
      unsigned int                node;
      std::array<unsigned int, 8> corners;
    };
    std::vector<InsertedNode> inserted_nodes;
  };
} // namespace Signorini
