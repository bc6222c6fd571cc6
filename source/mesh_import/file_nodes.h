// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/mesh_file.h"
#include <signorini/geometry/coarse_mesh.h>

namespace Signorini
{
  /// The nodes of a mesh file on the cells of a body, and the sets of them that have names.
  template <int dim>
  class FileNodes
  {
  public:
    FileNodes() = default;

    /// @param cells whose vertices are indices of nodes of the file, or beyond these if the cells
    /// have been divided; in the order and orientation of the final mesh
    /// @param elements of the cells; those of the shape of a cell may have nodes between corners
    /// @param representatives of nodes that were merged
    FileNodes(const MeshFile                               &file,
              const std::vector<dealii::CellData<dim>>     &cells,
              const std::vector<const MeshFile::Element *> &elements,
              const std::vector<unsigned int>              &representatives);

    /// The sets with nodes of these cells.
    std::vector<std::string>
    names() const;

    /// The nodes of a set that cells have, or the node of a number, or INSTANCE.NUMBER; empty if
    /// there are none.
    NodeSet<dim>
    find(const std::string &name) const;

  private:
    using Nodes = MeshFile::Nodes;

    unsigned int                  first_inserted = -1; ///< as in MeshFile
    std::vector<Nodes>            corners;             ///< of the cells, in deal.II's order
    std::map<unsigned int, Nodes> between; ///< the corners of which a node is the middle, in order
    std::map<std::string, Nodes>  sets;
    std::map<std::string, std::unordered_map<std::size_t, unsigned int>> numbers;
    Nodes
    nodes_called(const std::string &name) const;
  };
} // namespace Signorini
