#pragma once

#include <signorini/mesh/mesh_file.h>

#include <map>
#include <set>

namespace Signorini
{
  /// Which group of a mesh file gives a boundary face its name. Elements and faces go before sets
  /// of nodes; a set with all nodes of the part names nothing.
  class FaceNames
  {
  public:
    /// @param names the groups that are boundaries, the first of them that contains a face wins;
    /// empty: all groups, and a face must not be in two.
    /// @param representatives of nodes that were merged
    /// @param part_nodes of the cells
    FaceNames(const MeshFile                  &file,
              unsigned int                     dim,
              const std::vector<std::string>  &names,
              const std::vector<unsigned int> &representatives,
              const std::set<unsigned int>    &part_nodes);

    static constexpr unsigned int none = -1;

    /// Index of the name of a face with these corners, or `none`. Throws SceneError if the face is
    /// in two groups.
    unsigned int
    operator()(const MeshFile::Nodes &corners) const;

    const std::string &
    name(const unsigned int index) const
    {
      return names[index];
    }

  private:
    void
    add(const MeshFile::Nodes &face, unsigned int name);
    unsigned int
    one_of(const std::set<unsigned int> &candidates, const MeshFile::Nodes &corners) const;

    const MeshFile                                   &file;
    const std::vector<unsigned int>                  &representatives;
    const bool                                        in_order;
    std::vector<std::string>                          names;
    std::map<MeshFile::Nodes, std::set<unsigned int>> by_face;
    std::vector<std::pair<unsigned int, std::vector<bool>>>
      node_sets; ///< name, and is a node in it?
  };
} // namespace Signorini
