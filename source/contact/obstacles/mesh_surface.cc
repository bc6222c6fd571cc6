// SPDX-License-Identifier: Apache-2.0
#include "contact/obstacles/triangle_surface.h"
#include "mesh_import/cells.h"
#include "mesh_import/division/cell_shape.h"
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

    /// The nodes of second order in the middle of the edges and faces of some faces.
    class Middles
    {
    public:
      /// Find them among all elements, which alone know them: faces of sets are lists of corners,
      /// and may be those of solids. Neighbours of a face share what is in the middle of its edges,
      /// also if they are of first order themselves.
      Middles(const MeshFile &mesh, const std::vector<MeshFile::Nodes> &faces)
      {
        for (const MeshFile::Nodes &face : faces)
          {
            nodes[sorted(face)] = none;
            for (unsigned int i = 0; i < face.size(); ++i)
              nodes[edge_of(face, i)] = none;
          }
        for (const MeshFile::Element &element : mesh.elements)
          {
            const unsigned int dimension = dimension_of(element.shape);
            if (dimension != 2 && dimension != 3)
              continue;
            const CellShape &shape = CellShape::of(element.shape);
            for (unsigned int i = shape.n_corners; i < element.nodes.size(); ++i)
              if (const auto found = nodes.find(sorted(shape.corners_around(i, element)));
                  found != nodes.end())
                found->second = element.nodes[i];
          }
      }

      /// @return the corners of a face with the nodes in the middle of its edges between them.
      MeshFile::Nodes
      outline(const MeshFile::Nodes &face) const
      {
        MeshFile::Nodes result;
        for (unsigned int i = 0; i < face.size(); ++i)
          {
            result.push_back(face[i]);
            if (const unsigned int middle = nodes.at(edge_of(face, i)); middle != none)
              result.push_back(middle);
          }
        return result;
      }

      /// @return the node in the middle of a face; `none` if there is none.
      unsigned int
      center(const MeshFile::Nodes &face) const
      {
        return nodes.at(sorted(face));
      }

      static constexpr unsigned int none = -1;

    private:
      /// @return the ends of edge i of a face, sorted.
      static MeshFile::Nodes
      edge_of(const MeshFile::Nodes &face, const unsigned int i)
      {
        return sorted({face[i], face[(i + 1) % face.size()]});
      }

      std::map<MeshFile::Nodes, unsigned int> nodes; ///< by the corners around them, sorted
    };



    /// @return the triangles of a polygon from its first corner.
    std::vector<std::array<unsigned int, 3>>
    fan(const MeshFile::Nodes &polygon)
    {
      std::vector<std::array<unsigned int, 3>> result;
      for (unsigned int i = 2; i < polygon.size(); ++i)
        result.push_back({{polygon[0], polygon[i - 1], polygon[i]}});
      return result;
    }



    /// @return the triangles of a face. A quadrilateral is divided along its shorter diagonal. A
    /// face of second order is divided through its nodes: around that in its centre if there is
    /// one, otherwise the corners between the middles of two edges are cut off.
    std::vector<std::array<unsigned int, 3>>
    triangles_of(const MeshFile::Nodes       &face,
                 const Middles               &middles,
                 const std::vector<Point<3>> &nodes)
    {
      MeshFile::Nodes outline = middles.outline(face);
      if (const unsigned int center = middles.center(face); center != Middles::none)
        {
          outline.push_back(outline.front());
          outline.insert(outline.begin(), center);
          return fan(outline);
        }
      const auto is_middle = [&](const unsigned int node) {
        return std::find(face.begin(), face.end(), node) == face.end();
      };
      std::vector<std::array<unsigned int, 3>> result;
      MeshFile::Nodes                          rest;
      for (unsigned int i = 0, n = outline.size(); i < n; ++i)
        {
          const unsigned int last = outline[(i + n - 1) % n], next = outline[(i + 1) % n];
          if (is_middle(last) && is_middle(next))
            result.push_back({{last, outline[i], next}});
          else
            rest.push_back(outline[i]);
        }
      // Next to an edge of first order the rest has corners and middles. Triangles from a middle
      // never have three nodes of one edge.
      const auto n_middles = std::count_if(rest.begin(), rest.end(), is_middle);
      auto       start     = std::find_if(rest.begin(), rest.end(), is_middle);
      if (rest.size() == 4 && n_middles % 4 == 0)
        start = rest.begin() +
                (nodes[rest[1]].distance(nodes[rest[3]]) < nodes[rest[0]].distance(nodes[rest[2]]));
      std::rotate(rest.begin(), start, rest.end());
      for (const auto &triangle : fan(rest))
        result.push_back(triangle);
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
        const std::vector<MeshFile::Nodes>   faces = faces_of(mesh, surface);
        const Middles                        middles(mesh, faces);
        std::map<unsigned int, unsigned int> number;
        for (const MeshFile::Nodes &face : faces)
          for (auto triangle : triangles_of(face, middles, mesh.nodes))
            {
              for (unsigned int &node : triangle)
                {
                  const auto [entry, is_new] = number.insert({node, result.vertices.size()});
                  if (is_new)
                    result.vertices.push_back(mesh.nodes[node]);
                  node = entry->second;
                }
              result.corners.push_back(triangle);
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
