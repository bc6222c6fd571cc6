// SPDX-License-Identifier: Apache-2.0
#include "contact/obstacles/triangle_surface.h"
#include "mesh_import/formats/keyword_file.h"
#include "mesh_import/mesh_file.h"
#include <signorini/parameters/raw.h>

#include <algorithm>
#include <map>
#include <set>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The oriented corners of the elements of dimension two of a mesh file, or of the faces and
    /// elements of a set: elements that are listed for both of their sides count once. Throws
    /// SceneError.
    std::vector<MeshFile::Nodes>
    faces_of(const MeshFile &mesh, const std::string &surface)
    {
      std::vector<MeshFile::Nodes> candidates;
      const auto                   add_element = [&](const unsigned int e) {
        if (dimension_of(mesh.elements[e].shape) == 2)
          candidates.push_back(corners_of(mesh.elements[e]));
      };
      if (surface.empty())
        for (unsigned int e = 0; e < mesh.elements.size(); ++e)
          add_element(e);
      bool found = surface.empty();
      for (const MeshFile::Group &group : mesh.groups)
        if (upper_case(group.name) == upper_case(surface))
          {
            found = true;
            for (const MeshFile::Nodes &face : group.faces)
              candidates.push_back(face);
            for (const unsigned int e : group.elements)
              add_element(e);
          }
      if (!found)
        throw SceneError("has no set '" + surface + "'");
      std::vector<MeshFile::Nodes> result;
      std::set<MeshFile::Nodes>    known;
      for (const MeshFile::Nodes &face : candidates)
        {
          MeshFile::Nodes sorted = face;
          std::sort(sorted.begin(), sorted.end());
          if (face.size() > 2 && known.insert(sorted).second)
            result.push_back(face);
        }
      return result;
    }
  } // namespace



  Triangles
  read_mesh_surface(const std::string &file_name, const std::string &surface)
  {
    const MeshFile mesh = read_mesh_file(file_name);
    Triangles      result;
    try
      {
        std::map<unsigned int, unsigned int> number;
        for (const MeshFile::Nodes &face : faces_of(mesh, surface))
          {
            MeshFile::Nodes own;
            for (const unsigned int node : face)
              {
                const auto [entry, is_new] = number.insert({node, result.vertices.size()});
                if (is_new)
                  result.vertices.push_back(mesh.nodes[node]);
                own.push_back(entry->second);
              }
            // A quadrilateral is divided along its shorter diagonal.
            const auto &x = result.vertices;
            const bool  is_other =
              own.size() == 4 && x[own[1]].distance(x[own[3]]) < x[own[0]].distance(x[own[2]]);
            if (is_other)
              std::rotate(own.begin(), own.begin() + 1, own.end());
            for (unsigned int i = 2; i < own.size(); ++i)
              result.corners.push_back({{own[0], own[i - 1], own[i]}});
          }
        if (result.corners.empty())
          throw SceneError(surface.empty() ? "has no surface elements" :
                                             "has no surface elements in '" + surface + "'");
      }
    catch (const SceneError &error)
      {
        throw SceneError("mesh file '" + file_name + "' " + error.what());
      }
    return result;
  }
} // namespace Signorini
