// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/mesh_file.h"

#include <map>
#include <set>

namespace Signorini
{
  /// Decides which groups of a mesh file name a boundary face: those that contain the face, and
  /// sets of nodes that contain all its corners. A set with all nodes of the part names nothing.
  /// Refers to the file and the representatives.
  class FaceNames
  {
  public:
    /// @param file the mesh file
    /// @param dim dimension of the cells, 2 or 3
    /// @param names the groups that are boundaries, of which the first one that contains a face
    /// names it; empty: all groups, and a face has the names of all that contain it
    /// @param representatives of all nodes, after merging
    /// @param part_nodes the nodes of the cells of the part
    FaceNames(const MeshFile                  &file,
              unsigned int                     dim,
              const std::vector<std::string>  &names,
              const std::vector<unsigned int> &representatives,
              const std::set<unsigned int>    &part_nodes);

    /// @return indices of the names of a face; none if no group contains it.
    /// @param corners of the face in the mesh, which may be a part of a face of the file
    std::set<unsigned int>
    operator()(const MeshFile::Nodes &corners) const;

    /// @return a name.
    /// @param index as operator() returns it
    const std::string &
    name(const unsigned int index) const
    {
      return names[index];
    }

    /// @return messages about sets of nodes that are only partly a boundary, because some of their
    /// nodes are on no face with all its corners in the set.
    /// @param faces the corners of all boundary faces
    /// @param part_nodes the nodes of the cells of the part
    std::vector<std::string>
    notes(const std::vector<MeshFile::Nodes> &faces,
          const std::set<unsigned int>       &part_nodes) const;

  private:
    /// Register a name of a face.
    void
    add(const MeshFile::Nodes &face, unsigned int name);

    const MeshFile                                   &file;
    const std::vector<unsigned int>                  &representatives;
    const bool                                        in_order;
    std::vector<std::string>                          names;
    std::map<MeshFile::Nodes, std::set<unsigned int>> by_face;
    std::vector<std::pair<unsigned int, std::vector<bool>>>
      /// Indices of names, with one entry for each node of the file: whether it is in the set.
      node_sets;
  };
} // namespace Signorini
