// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/mesh_file.h"

#include <array>
#include <unordered_map>

namespace Signorini
{
  /// The nodes in the middle of edges and at the centers of faces, found by the corners, so that
  /// neighbours share them. Those of second order are in the file, others are made. Where a node
  /// lies depends on the nodes of its edge or face alone.
  class Centers
  {
  public:
    static constexpr unsigned int none = -1;

    explicit Centers(MeshFile &file)
      : file(file)
      , n_in_file(file.nodes.size())
    {}

    /// Take the nodes of second order of a cell. Throws SceneError if another cell has another node
    /// there.
    void
    take(const MeshFile::Element &cell);

    /// In the middle between two corners of an edge.
    unsigned int
    of_edge(unsigned int a, unsigned int b);

    /// At the center of a face of three or four corners, around.
    unsigned int
    of_face(const MeshFile::Nodes &around);

    /// In the middle of a diagonal of a quadrilateral: its center, if it is curved.
    unsigned int
    of_diagonal(const MeshFile::Nodes &around, unsigned int a, unsigned int b);

    /// A node of a cell with these corners, as one that is not shared.
    unsigned int
    of_cell(const MeshFile::Nodes &corners, const dealii::Point<3> &place);

    /// Put the nodes into all sets of nodes that contain the corners which they lie between.
    void
    complete_node_sets();

    /// Give them the mean of the values at these corners, in all scalars of the file that have none
    /// for them.
    void
    complete_fields();

    /// Up to four corners, sorted.
    using Key = std::array<unsigned int, 4>;

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
