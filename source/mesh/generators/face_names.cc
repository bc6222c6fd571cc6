#include <signorini/mesh/generators/cells.h>
#include <signorini/mesh/generators/face_names.h>
#include <signorini/parameters/raw.h>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    std::vector<std::string>
    names_of(const std::vector<MeshFile::Group> &groups)
    {
      std::vector<std::string> names;
      for (const auto &group : groups)
        names.push_back(group.name);
      return names;
    }
  } // namespace



  FaceNames::FaceNames(const MeshFile                  &file,
                       const unsigned int               dim,
                       const std::vector<std::string>  &chosen,
                       const std::vector<unsigned int> &representatives,
                       const std::set<unsigned int>    &part_nodes)
    : file(file)
    , representatives(representatives)
    , in_order(!chosen.empty())
    , names(in_order ? chosen : names_of(file.groups))
  {
    for (unsigned int n = 0; n < names.size(); ++n)
      for (const auto &group : file.groups)
        if (group.name == names[n])
          {
            for (const unsigned int e : group.elements)
              if (dimension_of(file.elements[e].shape) == dim - 1)
                add(corners_of(file.elements[e]), n);
            for (const auto &face : group.faces)
              add(face, n);

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



  unsigned int
  FaceNames::operator()(const MeshFile::Nodes &corners) const
  {
    std::set<unsigned int> candidates;
    const auto             found = by_face.find(sorted(corners));
    if (found != by_face.end())
      candidates = found->second;
    if (candidates.empty() || in_order)
      for (const auto &set : node_sets)
        if (std::all_of(corners.begin(), corners.end(), [&](const unsigned int node) {
              return set.second[node];
            }))
          candidates.insert(set.first);
    return one_of(candidates, corners);
  }



  unsigned int
  FaceNames::one_of(const std::set<unsigned int> &candidates, const MeshFile::Nodes &corners) const
  {
    if (candidates.empty())
      return none;
    if (candidates.size() > 1 && !in_order)
      throw SceneError("has a face at " + text_of(file.nodes[corners[0]]) + " that is both in '" +
                       names[*candidates.begin()] + "' and in '" + names[*candidates.rbegin()] +
                       "'; leave it in one, or list the boundaries that you need by the key "
                       "'Boundaries', first those that win");
    return *candidates.begin();
  }
} // namespace Signorini
