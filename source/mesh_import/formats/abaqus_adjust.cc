// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/division/cell_shape.h"
#include "mesh_import/formats/abaqus_reader.h"
#include <signorini/base/text.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <limits>

// ADJUST of *CONTACT PAIR: certain nodes of the slave surface are moved onto the master surface
// before the analysis, without strain.

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    using Nodes = MeshFile::Nodes;

    /// @return the point of the segment from a to b that is closest to x.
    Point<3>
    closest_on_edge(const Point<3> &x, const Point<3> &a, const Point<3> &b)
    {
      const double t = (x - a) * (b - a) / (b - a).norm_square();
      return a + std::clamp(t, 0., 1.) * (b - a);
    }



    /// A part of a master face: a straight edge in 2D, or a triangle. Its normal is that of the
    /// corners of the face, which are in an order such that it points into the body.
    struct Facet
    {
      std::vector<Point<3>> corners;
      Tensor<1, 3>          inward;

      explicit Facet(const std::vector<Point<3>> &corners)
        : corners(corners)
      {
        const Tensor<1, 3> edge = corners[1] - corners[0];
        inward                  = corners.size() == 2 ? Tensor<1, 3>({-edge[1], edge[0], 0}) :
                                                        cross_product_3d(edge, corners[2] - corners[0]);
        inward /= inward.norm();
      }

      /// @return the signed distance [length] of a point from the plane of the facet, positive
      /// outside the body.
      double
      height(const Point<3> &x) const
      {
        return -((x - corners[0]) * inward);
      }

      /// @return the orthogonal projection of a point onto the plane of the facet.
      Point<3>
      foot(const Point<3> &x) const
      {
        return x + height(x) * inward;
      }

      /// @return the point of the facet closest to x: the projection if that is inside, otherwise
      /// the closest point of an edge.
      Point<3>
      closest(const Point<3> &x) const
      {
        const Point<3>    below = foot(x);
        const std::size_t n     = corners.size();
        bool              is_in = n > 2;
        for (unsigned int i = 0; i < n && is_in; ++i)
          is_in =
            cross_product_3d(corners[(i + 1) % n] - corners[i], below - corners[i]) * inward >= 0;
        if (is_in)
          return below;
        Point<3> result = closest_on_edge(x, corners[0], corners[1]);
        for (unsigned int i = 1; i < n; ++i)
          if (const Point<3> other = closest_on_edge(x, corners[i], corners[(i + 1) % n]);
              x.distance(other) < x.distance(result))
            result = other;
        return result;
      }
    };



    /// @return the facets of all faces; a quadrilateral has four triangles, which meet at its
    /// centre.
    std::vector<Facet>
    facets_of(const std::vector<Nodes> &faces, const std::vector<Point<3>> &nodes)
    {
      std::vector<Facet> result;
      for (const Nodes &face : faces)
        {
          std::vector<Point<3>> corners;
          Point<3>              center;
          for (const unsigned int node : face)
            {
              corners.push_back(nodes[node]);
              center += nodes[node] / double(face.size());
            }
          if (face.size() < 4)
            result.emplace_back(corners);
          else
            for (unsigned int i = 0; i < face.size(); ++i)
              result.emplace_back(
                std::vector<Point<3>>{corners[i], corners[(i + 1) % face.size()], center});
        }
      return result;
    }



    /// @return the bounding boxes of all facets.
    std::vector<BoundingBox<3>>
    boxes_of(const std::vector<Facet> &facets)
    {
      std::vector<BoundingBox<3>> result;
      for (const Facet &facet : facets)
        result.emplace_back(facet.corners);
      return result;
    }



    /// The facets of a master surface in an R-tree of their bounding boxes.
    class MasterSurface
    {
    public:
      MasterSurface(const std::vector<Nodes> &faces, const std::vector<Point<3>> &nodes)
        : facets(facets_of(faces, nodes))
        , boxes(boxes_of(facets))
        , tree(pack_rtree_of_indices(boxes))
      {}

      /// @return the closest facet; null if the point is beside the surface, i.e. not above or
      /// below that facet.
      const Facet *
      facet_at(const Point<3> &x) const
      {
        // Facets are visited in the order of the distance of their boxes, until no box is closer
        // than the closest facet found.
        const Facet *result = nullptr;
        double       least  = std::numeric_limits<double>::max();
        for (auto i = tree.qbegin(boost::geometry::index::nearest(x, boxes.size()));
             i != tree.qend() && boost::geometry::distance(x, boxes[*i]) <= least;
             ++i)
          if (const double d = x.distance(facets[*i].closest(x)); d < least)
            {
              least  = d;
              result = &facets[*i];
            }
        if (!result) // all facets are flat
          return nullptr;
        // Near a convex edge of the surface the closest point is on the edge, and differs from the
        // projection along the normal; up to a slope of 0.3 the point is still above the facet.
        constexpr double largest_slope = 0.3;
        const double     height        = std::abs(result->height(x));
        return result->closest(x).distance(result->foot(x)) <= largest_slope * height ? result :
                                                                                        nullptr;
      }

    private:
      std::vector<Facet>          facets;
      std::vector<BoundingBox<3>> boxes;

      decltype(pack_rtree_of_indices(std::declval<const std::vector<BoundingBox<3>> &>())) tree;
    };



    /// @return the faces and nodes of all groups of a name, in any case of letters.
    MeshFile::Group
    surface_called(const MeshFile &file, const std::string &name)
    {
      MeshFile::Group result;
      for (const auto &group : file.groups)
        if (upper_case(group.name) == upper_case(name))
          {
            result.faces.insert(result.faces.end(), group.faces.begin(), group.faces.end());
            result.nodes.insert(result.nodes.end(), group.nodes.begin(), group.nodes.end());
          }
      return result;
    }



    /// @return the corners of the faces, or if there are none the nodes of the surface, and the
    /// nodes of second order between them.
    std::set<unsigned int>
    nodes_on(const MeshFile::Group &surface, const MeshFile &file)
    {
      std::set<unsigned int> result;
      if (surface.faces.empty())
        result.insert(surface.nodes.begin(), surface.nodes.end());
      for (const Nodes &face : surface.faces)
        result.insert(face.begin(), face.end());
      const std::set<unsigned int> corners = result;
      for (const auto &element : file.elements)
        if (const unsigned int dim = dimension_of(element.shape); dim == 2 || dim == 3)
          for (unsigned int i = n_corners(element.shape); i < element.nodes.size(); ++i)
            {
              const Nodes around = CellShape::of(element.shape).corners_around(i, element);
              if (std::all_of(around.begin(), around.end(), [&](const unsigned int node) {
                    return corners.count(node) > 0;
                  }))
                result.insert(element.nodes[i]);
            }
      return result;
    }
  } // namespace



  void
  AbaqusReader::read_adjustments()
  {
    for (Words words; in.has("ADJUST") && in.next_line(words);)
      if (words.size() > 1 && !words[1].empty())
        adjustments.push_back({words[0], words[1], in.value("ADJUST")});
  }



  /// As in CalculiX, the nodes of the set that ADJUST names are moved, or those that are at most
  /// the value of ADJUST outside the master surface.
  void
  AbaqusReader::adjust(const Adjustment &one)
  {
    MeshFile             &file   = *whole.mesh;
    const MeshFile::Group master = surface_called(file, one.master);
    if (master.faces.empty())
      return;
    std::set<unsigned int> of_set;
    const AbaqusSet *const set = whole.nodes.find(one.of);
    if (set)
      of_set.insert(set->members.begin(), set->members.end());
    const double        value = std::strtod(one.of.c_str(), nullptr);
    const MasterSurface surface(master.faces, file.nodes);
    unsigned int        n_moved  = 0;
    double              farthest = 0;
    for (const unsigned int node : nodes_on(surface_called(file, one.slave), file))
      {
        Point<3>    &x     = file.nodes[node];
        const Facet *facet = surface.facet_at(x);
        if (!facet || (set && of_set.count(node) == 0))
          continue;
        const double height       = facet->height(x),
                     size         = facet->corners[0].distance(facet->corners[1]);
        constexpr double rounding = 1e-10;
        // A node deeper inside than the width of a face belongs to another side of the body.
        if ((!set && height > value) || height < -size || std::abs(height) <= rounding * size)
          continue;
        x = facet->foot(x);
        ++n_moved;
        farthest = std::max(farthest, std::abs(height));
      }
    if (n_moved == 0)
      return;
    deck.adjusted.insert({upper_case(one.slave), upper_case(one.master)});
    notes.insert(std::to_string(n_moved) + " nodes of " + one.slave + " are moved onto " +
                 one.master + ", by at most " + short_text(farthest, 3) +
                 ", as ADJUST of *CONTACT PAIR says");
  }
} // namespace Signorini
