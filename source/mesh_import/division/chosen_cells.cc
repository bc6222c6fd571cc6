// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/division/chosen_cells.h"

#include "geometry/connected.h"
#include "mesh_import/division/cell_shape.h"
#include "mesh_import/division/centers.h"

namespace Signorini
{
  namespace
  {
    using Shape = MeshFile::Shape;
    using Nodes = MeshFile::Nodes;

    /// Mark connected sets of cells that contain at least one of a wanted shape.
    /// @param links a function that lists, for a shape, the positions of edges or faces by which
    /// cells are connected
    /// @param wanted a function of a shape
    /// @return one entry for each element of the file
    template <typename Links, typename Wanted>
    std::vector<bool>
    connected(const MeshFile                  &file,
              const std::vector<unsigned int> &cells,
              const Links                     &links,
              const Wanted                    &wanted)
    {
      Connected                                                     sets(cells.size());
      std::unordered_map<Centers::Key, unsigned int, Centers::Hash> cell_at;
      for (unsigned int c = 0; c < cells.size(); ++c)
        {
          const MeshFile::Element &element = file.elements[cells[c]];
          for (const Nodes &link : links(CellShape::of(element.shape)))
            sets.connect(c,
                         cell_at.insert({Centers::key(nodes_at(element, link)), c}).first->second);
        }
      std::vector<bool> is_wanted(cells.size()), result(file.elements.size());
      for (unsigned int c = 0; c < cells.size(); ++c)
        if (wanted(file.elements[cells[c]].shape))
          is_wanted[sets.first_of(c)] = true;
      for (unsigned int c = 0; c < cells.size(); ++c)
        result[cells[c]] = is_wanted[sets.first_of(c)];
      return result;
    }



    /// @return the quadrilateral faces of a shape.
    std::vector<Nodes>
    quadrilaterals(const CellShape &shape)
    {
      std::vector<Nodes> result;
      for (const Nodes &face : shape.faces)
        if (face.size() == 4)
          result.push_back(face);
      return result;
    }
  } // namespace



  std::vector<unsigned int>
  cells_of_part(const MeshFile &file, const unsigned int dim, const std::string &part)
  {
    std::vector<bool> wanted(file.elements.size(), part.empty());
    for (const auto &group : file.groups)
      if (!part.empty() && group.name == part)
        for (const unsigned int e : group.elements)
          wanted[e] = true;
    std::vector<unsigned int> cells;
    for (unsigned int e = 0; e < wanted.size(); ++e)
      if (wanted[e] && dimension_of(file.elements[e].shape) == dim)
        cells.push_back(e);
    return cells;
  }



  // Cells that are not quadrilaterals or hexahedra have to be divided, and with them all cells
  // connected to them by edges, because the edges get nodes in the middle. Pyramids become
  // tetrahedra first, and with them all cells connected to them by quadrilaterals, which get a
  // diagonal.
  ChosenCells::ChosenCells(const MeshFile &file, const unsigned int dim, const std::string &part)
    : all(file.elements.size())
    , as_simplices(file.elements.size())
  {
    const std::vector<unsigned int> cells   = cells_of_part(file, dim, part);
    const Shape                     regular = dim == 2 ? Shape::quadrilateral : Shape::hexahedron;
    std::array<unsigned int, 9>     n{};
    for (const unsigned int e : cells)
      ++n[static_cast<unsigned int>(file.elements[e].shape)];
    const unsigned int n_regular  = n[static_cast<unsigned int>(regular)],
                       n_pyramids = n[static_cast<unsigned int>(Shape::pyramid)];
    any                           = n_regular < cells.size();
    if (!any)
      return;
    if (n_regular == 0)
      for (const unsigned int e : cells)
        all[e] = true;
    else
      all = connected(
        file,
        cells,
        [](const CellShape &shape) { return shape.edges; },
        [&](const Shape shape) { return shape != regular; });
    if (n_pyramids > 0)
      as_simplices = connected(file, cells, quadrilaterals, [](const Shape shape) {
        return shape == Shape::pyramid;
      });
  }



  ChosenCells::ChosenCells(const MeshFile &file, const std::vector<unsigned int> &cells)
    : all(file.elements.size())
    , as_simplices(file.elements.size())
    , any(!cells.empty())
  {
    for (const unsigned int e : cells)
      all[e] = as_simplices[e] = true;
  }
} // namespace Signorini
