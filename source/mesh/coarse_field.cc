// SPDX-License-Identifier: Apache-2.0
#include "mesh/coarse_field.h"

#include <deal.II/base/geometry_info.h>

#include <limits>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  void
  CoarseField<dim>::append(const std::vector<CellData<dim>> &cells,
                           const std::vector<double>        &values)
  {
    if (!values.empty())
      {
        blocks.push_back({n_cells,
                          ReferenceCell::n_vertices_to_type(dim, cells[0].vertices.size()),
                          std::vector<Corners>(cells.size())});
        auto of_cell = blocks.back().cells.begin();
        for (const CellData<dim> &cell : cells)
          {
            for (unsigned int v = 0; v < cell.vertices.size(); ++v)
              (*of_cell)[v] = values.at(cell.vertices[v]);
            ++of_cell;
          }
      }
    n_cells += cells.size();
  }



  template <int dim>
  void
  CoarseField<dim>::number(const std::vector<types::coarse_cell_id> &ids)
  {
    index_of_id.resize(ids.size());
    for (unsigned int i = 0; i < ids.size(); ++i)
      index_of_id[ids[i]] = i;
  }



  // The coordinates are transformed from level to level to the coarse cell, where the values are
  // multilinear.
  template <int dim>
  double
  CoarseField<dim>::value(const CellId &cell, Point<dim> p) const
  {
    const auto &children = cell.get_child_indices();
    for (unsigned int level = children.size(); level-- > 0;)
      p = GeometryInfo<dim>::child_to_cell_coordinates(p, children[level]);
    const auto id    = cell.get_coarse_cell_id();
    const auto index = index_of_id.empty() ? id : index_of_id[id];
    for (const auto &[first, shape, corners] : blocks)
      if (index >= first && index < first + corners.size())
        {
          double sum = 0;
          for (const unsigned int v : shape.vertex_indices())
            sum += corners[index - first][v] * shape.d_linear_shape_function(p, v);
          return sum;
        }
    return std::numeric_limits<double>::quiet_NaN();
  }



  template class CoarseField<2>;
  template class CoarseField<3>;
} // namespace Signorini
