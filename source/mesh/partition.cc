// SPDX-License-Identifier: Apache-2.0
#include "mesh/mesh.h"

#include <deal.II/boost_adaptors/point.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_pattern.h>
#include <deal.II/numerics/rtree.h>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// @return the centres of the faces with some boundary ids, each with the index of its active
    /// cell.
    template <int dim>
    std::vector<std::pair<Point<dim>, unsigned int>>
    surface_cells(const Triangulation<dim> &triangulation, const BoundaryIds &ids)
    {
      std::vector<std::pair<Point<dim>, unsigned int>> surface;
      for (const auto &cell : triangulation.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() && ids.count(face->boundary_id()) > 0)
            surface.emplace_back(face->center(), cell->active_cell_index());
      return surface;
    }
  } // namespace



  // For each slave face the closest master face, by centres in an R-tree, becomes an edge of the
  // graph.
  template <int dim>
  void
  partition_by_metis(Triangulation<dim>                                     &triangulation,
                     const unsigned int                                      n_parts,
                     const std::vector<std::pair<BoundaryIds, BoundaryIds>> &pairs)
  {
    if (n_parts == 1)
      return;
    DynamicSparsityPattern graph;
    GridTools::get_face_connectivity_of_cells(triangulation, graph);
    for (const auto &[slave, master] : pairs)
      {
        const auto tree = pack_rtree(surface_cells(triangulation, master));
        for (const auto &[center, cell] : surface_cells(triangulation, slave))
          for (auto it = tree.qbegin(boost::geometry::index::nearest(center, 1)); it != tree.qend();
               ++it)
            {
              // The graph has to be symmetric. The additional edges make METIS prefer partitions in
              // which both sides of a contact are on one rank, which saves communication in the
              // search and in products with the gap operator.
              graph.add(cell, it->second);
              graph.add(it->second, cell);
            }
      }
    SparsityPattern compressed;
    compressed.copy_from(graph);
    GridTools::partition_triangulation(n_parts,
                                       compressed,
                                       triangulation,
                                       SparsityTools::Partitioner::metis);
  }

  template void
  partition_by_metis(Triangulation<2> &,
                     unsigned int,
                     const std::vector<std::pair<BoundaryIds, BoundaryIds>> &);
  template void
  partition_by_metis(Triangulation<3> &,
                     unsigned int,
                     const std::vector<std::pair<BoundaryIds, BoundaryIds>> &);
} // namespace Signorini
