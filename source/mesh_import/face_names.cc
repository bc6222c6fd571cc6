// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/cells.h"
#include "mesh_import/file_part_steps.h"
#include <signorini/parameters/raw.h>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// @return the names of all groups.
    std::vector<std::string>
    names_of(const std::vector<MeshFile::Group> &groups)
    {
      std::vector<std::string> names;
      for (const auto &group : groups)
        names.push_back(group.name);
      return names;
    }



    /// @return whether all corners are in a set.
    bool
    has_all(const std::vector<bool> &set, const MeshFile::Nodes &corners)
    {
      return std::all_of(corners.begin(), corners.end(), [&](const unsigned int node) {
        return set[node];
      });
    }
  } // namespace



  // Groups with faces name exactly these; groups with nodes only name each face all of whose
  // corners they contain. Nodes are replaced by their representatives before they are compared.
  FaceNames::FaceNames(const MeshFile                  &file,
                       const unsigned int               dim,
                       const std::vector<std::string>  &chosen,
                       const std::vector<unsigned int> &representatives,
                       const std::vector<unsigned int> &part_nodes)
    : file(file)
    , representatives(representatives)
    , in_order(!chosen.empty())
    , names(in_order ? chosen : names_of(file.groups))
  {
    for (unsigned int n = 0; n < names.size(); ++n)
      for (const auto &group : file.groups)
        if (group.name == names[n])
          {
            const auto is_face = [&](const unsigned int e) {
              return dimension_of(file.elements[e].shape) == dim - 1;
            };
            for (const unsigned int e : group.elements)
              if (is_face(e))
                add(corners_of(file.elements[e]), n);
            for (const auto &face : group.faces)
              add(face, n);

            // Beside a surface, nodes of the same name are another set.
            if (!group.faces.empty() ||
                std::any_of(group.elements.begin(), group.elements.end(), is_face))
              continue;
            std::vector<bool> contains(file.nodes.size());
            for (const unsigned int node : group.nodes)
              contains[representatives[node]] = true;
            const bool all = std::all_of(part_nodes.begin(),
                                         part_nodes.end(),
                                         [&](const unsigned int node) { return contains[node]; });
            if (!group.nodes.empty() && !all)
              node_sets.emplace_back(n, contains);
          }
  }



  void
  FaceNames::add(const MeshFile::Nodes &face, const unsigned int name)
  {
    MeshFile::Nodes corners;
    for (const unsigned int node : face)
      corners.push_back(representatives[node]);
    by_face[sorted(corners)].insert(name);
  }



  // Groups with the face itself, then node sets with all its corners; with given boundaries the
  // first one counts.
  std::set<unsigned int>
  FaceNames::operator()(const MeshFile::Nodes &part_of_face) const
  {
    // Cells may have been divided: names are those of the faces in the file.
    MeshFile::Nodes corners = file.parent_face(part_of_face);
    for (unsigned int &node : corners)
      node = representatives[node];
    std::set<unsigned int> result;
    const auto             found = by_face.find(sorted(corners));
    if (found != by_face.end())
      result = found->second;
    for (const auto &[name, set] : node_sets)
      if (has_all(set, corners))
        result.insert(name);
    if (in_order && result.size() > 1)
      result.erase(std::next(result.begin()), result.end());
    return result;
  }



  // Nodes of a set that are on no face with all corners in the set are counted, unless that holds
  // for all of them: then the set is not meant as a boundary.
  std::vector<std::string>
  FaceNames::notes(const std::vector<MeshFile::Nodes> &faces,
                   const std::vector<unsigned int>    &part_nodes) const
  {
    std::vector<std::string> result;
    for (const auto &[name, set] : node_sets)
      {
        std::set<unsigned int> rest;
        for (const unsigned int node : part_nodes)
          if (set[node])
            rest.insert(node);
        const std::size_t all = rest.size();
        for (const MeshFile::Nodes &corners : faces)
          if (has_all(set, corners))
            for (const unsigned int node : corners)
              rest.erase(node);
        if (!rest.empty() && rest.size() < all)
          result.push_back("node set '" + names[name] + "': " + std::to_string(rest.size()) +
                           " of its " + std::to_string(all) +
                           " nodes here are on no face with all its corners in the set, and so not "
                           "on the boundary of that name; the key Nodes takes them all");
      }
    return result;
  }
} // namespace Signorini
