// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/mesh_file.h"

#include <map>
#include <set>

namespace Signorini
{
  /// Which groups of a mesh file give a boundary face its names: those with the face, and sets of
  /// nodes with all its corners. A set with all nodes of the part names nothing.
  class FaceNames
  {
  public:
    /// @param names the groups that are boundaries, the first of them that contains a face wins;
    /// empty: all groups, and a face has as many names as contain it.
    /// @param representatives of nodes that were merged
    /// @param part_nodes of the cells
    FaceNames(const MeshFile                  &file,
              unsigned int                     dim,
              const std::vector<std::string>  &names,
              const std::vector<unsigned int> &representatives,
              const std::set<unsigned int>    &part_nodes);

    /// Indices of the names of a face with these corners.
    std::set<unsigned int>
    operator()(const MeshFile::Nodes &corners) const;

    const std::string &
    name(const unsigned int index) const
    {
      return names[index];
    }

    /// What is to be said of sets of nodes that are boundaries in part only: nodes that no face of
    /// the boundary has. @param faces the corners of all boundary faces
    std::vector<std::string>
    notes(const std::vector<MeshFile::Nodes> &faces,
          const std::set<unsigned int>       &part_nodes) const;

  private:
    void
    add(const MeshFile::Nodes &face, unsigned int name);

    const MeshFile                                   &file;
    const std::vector<unsigned int>                  &representatives;
    const bool                                        in_order;
    std::vector<std::string>                          names;
    std::map<MeshFile::Nodes, std::set<unsigned int>> by_face;
    std::vector<std::pair<unsigned int, std::vector<bool>>>
      node_sets; ///< name, and is a node in it?
  };
} // namespace Signorini
