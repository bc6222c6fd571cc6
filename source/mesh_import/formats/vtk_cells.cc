// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/formats/vtk_cells.h"

#include <signorini/parameters/raw.h>

#include <algorithm>
#include <map>

namespace Signorini
{
  namespace
  {
    constexpr unsigned int pixel = 8, voxel = 11; // these cross over, the others go around

    /// @return for a Lagrange cell of first or second order the type of the ordinary cell with the
    /// same order of nodes; other types unchanged.
    unsigned int
    plain_type(const unsigned int type, const unsigned int n_nodes)
    {
      static const std::map<std::pair<unsigned int, unsigned int>, unsigned int> types = {
        {{69, 3}, 5},
        {{69, 6}, 22},
        {{70, 4}, 9},
        {{70, 9}, 28},
        {{71, 4}, 10},
        {{71, 10}, 24},
        {{72, 8}, 12},
        {{73, 6}, 13},
        {{74, 5}, 14}};
      const auto found = types.find({type, n_nodes});
      return found == types.end() ? type : found->second;
    }



    /// @return shape and number of nodes of a type of VTK; unknown and 0 if it is not supported.
    std::pair<MeshFile::Shape, unsigned int>
    vtk_type(const unsigned int type)
    {
      using Shape                                                               = MeshFile::Shape;
      static const std::map<unsigned int, std::pair<Shape, unsigned int>> types = {
        {1, {Shape::point, 1}},          {3, {Shape::line, 2}},
        {5, {Shape::triangle, 3}},       {pixel, {Shape::quadrilateral, 4}},
        {9, {Shape::quadrilateral, 4}},  {10, {Shape::tetrahedron, 4}},
        {voxel, {Shape::hexahedron, 8}}, {12, {Shape::hexahedron, 8}},
        {13, {Shape::wedge, 6}},         {14, {Shape::pyramid, 5}},
        {21, {Shape::line, 3}},          {22, {Shape::triangle, 6}},
        {23, {Shape::quadrilateral, 8}}, {24, {Shape::tetrahedron, 10}},
        {25, {Shape::hexahedron, 20}},   {26, {Shape::wedge, 15}},
        {27, {Shape::pyramid, 13}},      {28, {Shape::quadrilateral, 9}},
        {29, {Shape::hexahedron, 27}},   {32, {Shape::wedge, 18}},
        {34, {Shape::triangle, 7}}};
      const auto found = types.find(type);
      return found == types.end() ? std::make_pair(Shape::unknown, 0u) : found->second;
    }



    /// Add a cell with nodes in the order of MeshFile::Element. Only the pixel and the voxel, which
    /// have lexicographic order, and the triangle with a node at its centre differ from it.
    void
    add_cell(MeshFile &file, const unsigned int type, const MeshFile::Nodes &nodes)
    {
      const auto [shape, n] = vtk_type(plain_type(type, nodes.size()));
      if (n > 0 && nodes.size() != n)
        throw SceneError("has cell " + std::to_string(file.elements.size()) + " of type " +
                         std::to_string(type) + " without its " + std::to_string(n) + " points");
      file.elements.push_back({shape, "type " + std::to_string(type), file.elements.size(), nodes});
      MeshFile::Nodes &corners = file.elements.back().nodes;
      if (type == pixel || type == voxel)
        for (unsigned int first = 0; first < n; first += 4)
          std::swap(corners[first + 2], corners[first + 3]);
      if (shape == MeshFile::Shape::triangle && n == 7)
        corners.pop_back(); // the center bends nothing at the edges
    }
  } // namespace



  void
  add_vtk_cells(MeshFile                &file,
                const std::vector<long> &types,
                const std::vector<long> &offsets,
                const std::vector<long> &points)
  {
    if (offsets.size() != types.size() + 1)
      throw SceneError("does not have as many cells as types of cells");
    for (std::size_t i = 0; i < types.size(); ++i)
      {
        const long begin = offsets[i], end = offsets[i + 1];
        if (begin < 0 || end < begin || end > static_cast<long>(points.size()))
          throw SceneError("has no points for cell " + std::to_string(i));
        // Larger ones would become others, which are there, as indices.
        for (long j = begin; j < end; ++j)
          if (points[j] < 0 || points[j] >= static_cast<long>(file.nodes.size()))
            throw SceneError("has a cell with the unknown point " + std::to_string(points[j]));
        add_cell(file, types[i], {points.begin() + begin, points.begin() + end});
      }
  }



  void
  add_vtk_groups(MeshFile &file, const std::string &name, const std::vector<long> &values)
  {
    constexpr unsigned int                    most = 1000;
    std::map<long, std::vector<unsigned int>> members;
    for (unsigned int i = 0; i < values.size() && members.size() <= most; ++i)
      members[values[i]].push_back(i);
    if (members.size() <= most)
      for (const auto &[value, elements] : members)
        file.group(name + " " + std::to_string(value)).elements = elements;
  }



} // namespace Signorini
