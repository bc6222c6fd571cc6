// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/cells.h"
#include "mesh_import/division/cell_shape.h"
#include "mesh_import/formats/abaqus_elements.h"
#include "mesh_import/formats/keyword_file.h"
#include "mesh_import/import_steps.h"
#include <signorini/parameters/raw.h>

#include <algorithm>
#include <numeric>
#include <set>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    using Nodes = MeshFile::Nodes;

    /// Cuts one mesh along one surface.
    class Cut
    {
    public:
      Cut(MeshFile &file, const std::string &surface)
        : file(file)
        , surface(surface)
      {
        find_faces();
        find_cells();
        find_sides();
      }

      /// Double the nodes. @return the copy of each of them
      std::map<unsigned int, unsigned int>
      double_nodes()
      {
        for (const auto &[node, around] : cells_at)
          for (const std::vector<unsigned int> &fan : fans_around(node, around))
            {
              bool is_upper = false, is_lower = false;
              for (const unsigned int e : fan)
                {
                  is_upper |= upper.count(e) > 0;
                  is_lower |= lower.count(e) > 0;
                }
              // Cells of both sides are connected around an end of the cut inside of the mesh.
              if (is_upper && is_lower)
                fail("it ends inside of the mesh; let it end at the surface");
              if (!is_upper)
                continue;
              if (copies.insert({node, file.nodes.size()}).second)
                {
                  const Point<3> place = file.nodes[node];
                  file.nodes.push_back(place);
                  for (auto &[name, values] : file.fields)
                    {
                      const double value = values[node];
                      values.push_back(value);
                    }
                }
              for (const unsigned int e : fan)
                changed[e].push_back(node);
            }
        for (const auto &[e, nodes] : changed)
          rename_nodes(e);
        return copies;
      }

      /// Let groups refer to the copies too.
      void
      complete_groups(const std::string &other_side)
      {
        MeshFile::Group other{other_side, {}, {}, {}};
        for (const Nodes &face : cut_faces)
          other.faces.push_back(with_copies(face));
        for (MeshFile::Group &group : file.groups)
          {
            for (Nodes &face : group.faces)
              if (const auto found = renamed.find(sorted(face)); found != renamed.end())
                face = found->second;
            const Nodes before = group.nodes;
            for (const unsigned int node : before)
              if (const auto copy = copies.find(node); copy != copies.end())
                group.nodes.push_back(copy->second);
          }
        // Elements of a lower dimension are faces.
        for (MeshFile::Element &element : file.elements)
          if (dimension_of(element.shape) + 1 == dim)
            if (renamed.count(sorted(corners_of(element))) > 0)
              element.nodes = with_copies(element.nodes);
        file.groups.push_back(other);
      }

    private:
      [[noreturn]] void
      fail(const std::string &what) const
      {
        throw SceneError("the mesh cannot be cut along '" + surface + "': " + what);
      }

      void
      find_faces()
      {
        for (const auto &element : file.elements)
          if (element.shape != MeshFile::Shape::unknown)
            dim = std::max(dim, dimension_of(element.shape));
        for (const auto &group : file.groups)
          if (upper_case(group.name) == upper_case(surface))
            {
              cut_faces.insert(cut_faces.end(), group.faces.begin(), group.faces.end());
              for (const unsigned int e : group.elements)
                if (dimension_of(file.elements[e].shape) + 1 == dim)
                  cut_faces.push_back(corners_of(file.elements[e]));
            }
        if (cut_faces.empty())
          fail("there is no surface with faces of that name");
        for (const Nodes &face : cut_faces)
          is_cut.insert(sorted(face));
      }

      /// The cells at each node of the surface, with the nodes of second order between its corners.
      void
      find_cells()
      {
        std::set<unsigned int> corners;
        for (const Nodes &face : cut_faces)
          corners.insert(face.begin(), face.end());
        for (unsigned int e = 0; e < file.elements.size(); ++e)
          {
            const MeshFile::Element &element = file.elements[e];
            if (dimension_of(element.shape) != dim)
              continue;
            for (unsigned int i = 0; i < element.nodes.size(); ++i)
              {
                const Nodes around = corners_at(element, i);
                if (std::all_of(around.begin(), around.end(), [&](const unsigned int node) {
                      return corners.count(node) > 0;
                    }))
                  cells_at[element.nodes[i]].push_back(e);
              }
          }
      }

      /// Node i of a cell, if it is a corner; else the corners between which it lies.
      static Nodes
      corners_at(const MeshFile::Element &element, const unsigned int i)
      {
        return i < n_corners(element.shape) ?
                 Nodes{element.nodes[i]} :
                 CellShape::of(element.shape).corners_around(i, element);
      }

      Point<3>
      center(const Nodes &nodes) const
      {
        Point<3> result;
        for (const unsigned int node : nodes)
          result += file.nodes[node] / double(nodes.size());
        return result;
      }

      /// The normal of a face, with its area as length.
      Tensor<1, 3>
      normal(const Nodes &face) const
      {
        const std::vector<Point<3>> &x = file.nodes;
        if (dim == 2)
          {
            const Tensor<1, 3> edge = x[face[1]] - x[face[0]];
            return Tensor<1, 3>({-edge[1], edge[0], 0});
          }
        return face.size() == 3 ?
                 0.5 * cross_product_3d(x[face[1]] - x[face[0]], x[face[2]] - x[face[0]]) :
                 0.5 * cross_product_3d(x[face[2]] - x[face[0]], x[face[3]] - x[face[1]]);
      }

      /// The cells at the faces of the surface, above and below it.
      void
      find_sides()
      {
        Tensor<1, 3> mean;
        for (const Nodes &face : cut_faces)
          mean += (normal(face) * mean < 0 ? -1. : 1.) * normal(face);
        mean /= mean.norm();
        // In the order of the file: the side of a face tells one cell from the other.
        std::map<Nodes, unsigned int> n_cells;
        for (const auto &[node, around] : cells_at)
          for (const unsigned int e : around)
            for (const Nodes &face : abaqus_faces(file.elements[e], ""))
              if (is_cut.count(sorted(face)) > 0 && seen.insert({e, sorted(face)}).second)
                {
                  const Tensor<1, 3> n = normal(face);
                  // Plane up to 45 degrees, so that the sides are those of the mean plane.
                  if (std::abs(n * mean) < 0.71 * n.norm())
                    fail("it is not plane");
                  const double height =
                    (center(corners_of(file.elements[e])) - center(face)) * mean;
                  (height > 0 ? upper : lower).insert(e);
                  ++n_cells[sorted(face)];
                }
        for (const Nodes &face : is_cut)
          if (n_cells[face] != 2)
            fail("it is not inside of the mesh everywhere, with a cell on either side");
      }

      /// The cells around a node in groups that are connected through faces that are not cut.
      std::vector<std::vector<unsigned int>>
      fans_around(const unsigned int node, const std::vector<unsigned int> &around) const
      {
        // Cells with a common face that contains the node, or its neighbours, are in one group.
        std::map<Nodes, std::vector<unsigned int>> cells_of_face;
        for (unsigned int i = 0; i < around.size(); ++i)
          for (const Nodes &face : abaqus_faces(file.elements[around[i]], ""))
            if (const Nodes key = sorted(face);
                is_cut.count(key) == 0 && touches(face, node, around[i]))
              cells_of_face[key].push_back(i);
        std::vector<unsigned int> fan(around.size());
        std::iota(fan.begin(), fan.end(), 0);
        for (const auto &[face, cells] : cells_of_face)
          for (unsigned int i = 1; i < cells.size(); ++i)
            {
              const unsigned int from = fan[cells[i]], to = fan[cells[0]];
              std::replace(fan.begin(), fan.end(), from, to);
            }
        std::map<unsigned int, std::vector<unsigned int>> result;
        for (unsigned int i = 0; i < around.size(); ++i)
          result[fan[i]].push_back(around[i]);
        std::vector<std::vector<unsigned int>> list;
        for (auto &[number, cells] : result)
          list.push_back(std::move(cells));
        return list;
      }

      /// True if a node of a cell, or the corners between which it lies, are corners of a face.
      bool
      touches(const Nodes &face, const unsigned int node, const unsigned int e) const
      {
        const MeshFile::Element &element = file.elements[e];
        const unsigned int       i =
          std::find(element.nodes.begin(), element.nodes.end(), node) - element.nodes.begin();
        const Nodes around = corners_at(element, i);
        return std::all_of(around.begin(), around.end(), [&](const unsigned int corner) {
          return std::count(face.begin(), face.end(), corner) > 0;
        });
      }

      Nodes
      with_copies(Nodes nodes) const
      {
        for (unsigned int &node : nodes)
          if (const auto copy = copies.find(node); copy != copies.end())
            node = copy->second;
        return nodes;
      }

      /// Let a cell have the copies of its nodes that were doubled.
      void
      rename_nodes(const unsigned int e)
      {
        MeshFile::Element       &element = file.elements[e];
        const std::vector<Nodes> before  = abaqus_faces(element, "");
        for (unsigned int &node : element.nodes)
          if (std::count(changed[e].begin(), changed[e].end(), node) > 0)
            node = copies[node];
        const std::vector<Nodes> after = abaqus_faces(element, "");
        for (unsigned int i = 0; i < before.size(); ++i)
          if (before[i] != after[i] && is_cut.count(sorted(before[i])) == 0)
            renamed[sorted(before[i])] = after[i];
      }

      MeshFile          &file;
      const std::string &surface;
      unsigned int       dim = 0;
      std::vector<Nodes> cut_faces;
      std::set<Nodes>    is_cut;
      /// Cells by the nodes of the surface.
      std::map<unsigned int, std::vector<unsigned int>> cells_at;
      std::set<unsigned int>                            upper, lower;
      std::set<std::pair<unsigned int, Nodes>>          seen;
      std::map<unsigned int, unsigned int>              copies;
      /// The nodes of cells of which these get the copies.
      std::map<unsigned int, Nodes> changed;
      /// Faces, beside those of the surface, of which nodes were replaced: as they are now, by
      /// their sorted corners before.
      std::map<Nodes, Nodes> renamed;
    };
  } // namespace



  std::map<unsigned int, unsigned int>
  cut_mesh(MeshFile &file, const std::string &surface, const std::string &other_side)
  {
    Cut        cut(file, surface);
    const auto copies = cut.double_nodes();
    cut.complete_groups(other_side);
    return copies;
  }
} // namespace Signorini
