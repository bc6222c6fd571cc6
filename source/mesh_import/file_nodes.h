// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/mesh_file.h"
#include <signorini/geometry/coarse_mesh.h>

namespace Signorini
{
  /// The nodes of a mesh file as points of the cells of a body, and their named sets. Mid-side
  /// nodes are points of the reference cell between vertices.
  template <int dim>
  class FileNodes
  {
  public:
    FileNodes() = default;

    /// @param file the mesh file
    /// @param cells whose vertices are indices of nodes of the file, or beyond these if the cells
    /// have been divided; in the order and orientation of the final mesh
    /// @param elements of the cells; those that have not been divided may have nodes between their
    /// corners
    /// @param representatives of all nodes, after merging
    FileNodes(const MeshFile                               &file,
              const std::vector<dealii::CellData<dim>>     &cells,
              const std::vector<const MeshFile::Element *> &elements,
              const std::vector<unsigned int>              &representatives);

    /// @return the names of the sets that contain nodes of these cells.
    std::vector<std::string>
    names() const;

    /// @return the nodes of a set that the cells have, each with its position in all cells that
    /// share it; empty if there are none.
    /// @param name of a set, the number of a node, or INSTANCE.NUMBER
    NodeSet<dim>
    find(const std::string &name) const;

  private:
    using Nodes = MeshFile::Nodes;

    /// A node within an edge, a face or the interior of a cell, given by the vertices around it,
    /// bit by bit.
    struct Middle
    {
      unsigned int node, cell, vertices;
    };

    /// As MeshFile::first_inserted.
    unsigned int first_inserted = -1;
    /// The number of vertices of a cell, and the vertices of all cells, cell by cell in deal.II's
    /// order, as indices of nodes of the file.
    unsigned int n_vertices = 0;
    Nodes        vertices;
    /// Mid-side nodes in ascending order, each as that of one of its cells.
    std::vector<Middle>                                                  middles;
    std::map<std::string, Nodes>                                         sets;
    std::map<std::string, std::unordered_map<std::size_t, unsigned int>> numbers;
    Nodes
    nodes_called(const std::string &name) const;
    const Middle *
    middle_at(unsigned int node) const;
    Nodes
    vertices_around(const Middle &middle) const;
  };
} // namespace Signorini
