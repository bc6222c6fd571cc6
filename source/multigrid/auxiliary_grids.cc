// SPDX-License-Identifier: Apache-2.0
#include "multigrid/auxiliary_grids.h"

#include "geometry/connected.h"
#include "linear_algebra/galerkin_product.h"
#include "linear_algebra/smoothed_aggregation.h"
#include "matrix_free/cell_operator.h"
#include "multigrid/condensed_cells.h"
#include "multigrid/node_grids.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    using Index = types::global_dof_index;

    /// One step of coarsening: interpolation from grids that have been made coarser, and the nodes
    /// there.
    class GridStep
    {
    public:
      GridStep(const LA::NodeGraph         &graph,
               const GridNodes             &nodes,
               const std::vector<PartGrid> &grids);

      LA::NodeInterpolation interpolation;
      /// The grid nodes of this rank.
      GridNodes coarse;

    private:
      void
      place_corners(const GridNodes &nodes, const std::vector<PartGrid> &grids);
      void
      connect();
      void
      number_sets(const GridNodes &nodes);

      const LA::NodeGraph       &graph;
      const unsigned int         stride;
      std::vector<GridCorner>    corners; ///< `stride` for each node
      std::vector<unsigned char> n_corners;
      Connected                  sets; ///< of corners
    };

    GridStep::GridStep(const LA::NodeGraph         &graph,
                       const GridNodes             &nodes,
                       const std::vector<PartGrid> &grids)
      : coarse(0)
      , graph(graph)
      , stride(1u << graph.n_components)
      , corners(std::size_t(graph.size()) * stride)
      , n_corners(graph.size(), 0)
      , sets(graph.size() * stride)
    {
      place_corners(nodes, grids);
      connect();
      number_sets(nodes);
    }

    void
    GridStep::place_corners(const GridNodes &nodes, const std::vector<PartGrid> &grids)
    {
      std::array<GridCorner, 8> found;
      for (std::uint32_t node = 0; node < graph.size(); ++node)
        if (graph.is_kept(node))
          {
            n_corners[node]        = 1;
            corners[node * stride] = {0, 1.};
          }
        else if (nodes.parts[node] != GridNodes::no_part && graph.is_free(node))
          {
            n_corners[node] = find_corners(nodes.places[node],
                                           nodes.sizes[node],
                                           grids[nodes.parts[node]],
                                           graph.n_components,
                                           found);
            std::copy_n(found.begin(), n_corners[node], corners.begin() + node * stride);
          }
    }

    // Corners at the same place are one unknown if nodes that refer to them are coupled.
    void
    GridStep::connect()
    {
      for (std::uint32_t node = 0; node < graph.size(); ++node)
        if (!graph.is_kept(node))
          for (const std::uint32_t *other = graph.begin(node); other != graph.end(node); ++other)
            if (!graph.is_kept(*other))
              {
                std::uint32_t       a = node * stride, b = *other * stride;
                const std::uint32_t end_a = a + n_corners[node], end_b = b + n_corners[*other];
                while (a < end_a && b < end_b)
                  if (corners[a].key < corners[b].key)
                    ++a;
                  else if (corners[b].key < corners[a].key)
                    ++b;
                  else
                    sets.connect(a++, b++);
              }
    }

    // A set of corners is a coarse node, of the rank that owns the corner with the largest number.
    void
    GridStep::number_sets(const GridNodes &nodes)
    {
      constexpr double    none = -1;
      const std::uint32_t n    = graph.size();
      std::vector<double> own(corners.size(), none);
      std::vector<double> sizes(corners.size(), -std::numeric_limits<double>::max());
      for (std::uint32_t node = 0; node < n; ++node)
        for (unsigned int k = 0; k < n_corners[node]; ++k)
          {
            own[node * stride + k]   = double(graph.global(node)) * stride + k;
            sizes[node * stride + k] = -nodes.sizes[node];
          }
      std::vector<double> labels = own;
      enlarge(graph, sets, stride, labels);
      enlarge(graph, sets, stride, sizes);

      std::vector<std::uint32_t> roots;
      for (std::uint32_t i = 0; i < graph.n_owned() * stride; ++i)
        if (own[i] != none && labels[i] == own[i])
          roots.push_back(i);
      interpolation.owned = LA::contiguous_partition(roots.size(), graph.comm);
      std::vector<double> numbers(corners.size(), none);
      coarse = GridNodes(roots.size());
      for (std::uint32_t r = 0; r < roots.size(); ++r)
        {
          const std::uint32_t i = roots[r];
          numbers[i]            = interpolation.owned.nth_index_in_set(r);
          coarse.places[r]      = place_of(corners[i].key, graph.n_components);
          coarse.sizes[r]       = -sizes[i];
          coarse.parts[r]       = nodes.parts[i / stride];
        }
      enlarge(graph, sets, stride, numbers);

      interpolation.first.push_back(0);
      for (std::uint32_t node = 0; node < n; ++node)
        {
          for (unsigned int k = 0; k < n_corners[node]; ++k)
            {
              interpolation.coarse.push_back(numbers[node * stride + k]);
              interpolation.weights.push_back(corners[node * stride + k].weight);
            }
          interpolation.first.push_back(interpolation.coarse.size());
        }
    }

    /// Extend coordinates by those of nodes of other ranks. Collective.
    void
    fetch(const LA::NodeGraph &graph, std::vector<Place> &points)
    {
      std::vector<double> coordinate;
      points.resize(graph.size());
      for (unsigned int d = 0; d < graph.n_components; ++d)
        {
          coordinate.resize(graph.size());
          for (std::uint32_t node = 0; node < graph.n_owned(); ++node)
            coordinate[node] = points[node][d];
          graph.fetch(coordinate);
          for (std::uint32_t node = 0; node < graph.size(); ++node)
            points[node][d] = coordinate[node];
        }
    }

    void
    fetch(const LA::NodeGraph &graph, GridNodes &nodes)
    {
      fetch(graph, nodes.places);
      graph.fetch(nodes.sizes);
      graph.fetch(nodes.parts);
    }

    /// The coordinates of the nodes of this rank.
    std::vector<double>
    coordinates(const LA::NodeGraph         &graph,
                const std::vector<PartGrid> &grids,
                const GridNodes             &nodes)
    {
      std::vector<double> result;
      for (std::uint32_t node = 0; node < graph.n_owned(); ++node)
        for (unsigned int d = 0; d < graph.n_components; ++d)
          if (nodes.parts[node] == GridNodes::no_part)
            result.push_back(0);
          else
            {
              const PartGrid &grid = grids[nodes.parts[node]];
              result.push_back(grid.origin[d] + nodes.places[node][d] * grid.spacing[d]);
            }
      return result;
    }

    /// The levels below the one with a graph. Collective.
    /// @param owned unknowns of the finest level
    /// @param add adds P^T K P of the finest level
    Spaces
    grid_levels(std::unique_ptr<const LA::NodeGraph>              graph,
                const NodePositions                              &given,
                const IndexSet                                   &owned,
                const std::function<void(LA::GalerkinProduct &)> &add)
    {
      const unsigned int dim = given.dim;
      std::vector<Place> positions(graph->n_owned());
      for (std::uint32_t node = 0; node < graph->n_owned(); ++node)
        std::copy_n(given.coordinates.begin() + node * dim, dim, positions[node].begin());
      fetch(*graph, positions);
      auto [grids, nodes] = make_grids(*graph, positions);
      fetch(*graph, nodes);

      Spaces   result{{}, given};
      IndexSet present = owned;
      while (present.size() > LA::factorised_size)
        {
          std::vector<double> fewer;
          for (PartGrid &grid : grids)
            fewer.push_back(coarsen(grid, dim));
          double expected = 0;
          for (std::uint32_t node = 0; node < graph->n_owned(); ++node)
            expected += nodes.parts[node] == GridNodes::no_part ? 0 : 1 / fewer[nodes.parts[node]];
          expected = Utilities::MPI::sum(expected, graph->comm);
          GridStep step(*graph, nodes, grids);
          // Where a grid has one cell across a thin body, it cannot bend, and does not become much
          // coarser either. Aggregates with rotations are better then. There is no grid either
          // where all nodes are supported.
          const Index n_coarse = step.interpolation.owned.size();
          if (n_coarse == 0 || 10 * dim * n_coarse > 7 * present.size() ||
              (n_coarse > 1.9 * expected && dim * n_coarse > LA::factorised_size))
            break;
          LA::GalerkinProduct product(*graph, step.interpolation);
          if (result.levels.empty())
            add(product);
          else
            product.add(*result.levels.back().matrix);
          LA::SparseMatrix coarse = product.finish();
          result.levels.emplace_back(std::make_unique<AssembledProlongation>(
                                       LA::matrix_of(step.interpolation, *graph, present)),
                                     std::move(coarse));
          present = result.levels.back().matrix->locally_owned_range_indices();
          graph = std::make_unique<LA::NodeGraph>(*result.levels.back().matrix, dim, given.n_rigid);
          nodes = std::move(step.coarse);
          fetch(*graph, nodes);
        }
      if (!result.levels.empty())
        result.nodes.coordinates = coordinates(*graph, grids, nodes);
      return result;
    }
  } // namespace



  Spaces
  auxiliary_grids(const LA::SparseMatrix &K, const NodePositions &nodes)
  {
    if (K.m() <= LA::factorised_size)
      return {{}, nodes};
    return grid_levels(std::make_unique<LA::NodeGraph>(K, nodes.dim, nodes.n_rigid),
                       nodes,
                       K.locally_owned_range_indices(),
                       [&](LA::GalerkinProduct &product) { product.add(K); });
  }



  Spaces
  auxiliary_grids(const CellSpace &space, const NodePositions &nodes)
  {
    if (space.owned.size() <= LA::factorised_size)
      return {{}, nodes};
    const CondensedCells cells(space);
    const auto is_free = [&](const Index dof) { return !space.constraints.is_constrained(dof); };
    auto       graph   = std::make_unique<LA::NodeGraph>(
      cells.nodes(), is_free, space.owned, nodes.dim, nodes.n_rigid, space.comm);
    const LA::NodeGraph &finest = *graph;
    return grid_levels(std::move(graph), nodes, space.owned, [&](LA::GalerkinProduct &product) {
      cells.add_to(product, finest);
    });
  }



  namespace
  {
    void
    append(Spaces &&more, Spaces &spaces)
    {
      std::move(more.levels.begin(), more.levels.end(), std::back_inserter(spaces.levels));
      spaces.nodes = std::move(more.nodes);
    }
  } // namespace



  void
  append_last(Spaces                             &spaces,
              std::unique_ptr<const Prolongation> P,
              const CellSpace                    &space,
              const NodePositions                &nodes)
  {
    // A node of tetrahedra has half as many neighbours as one of hexahedra, and three times as many
    // cells: there products with a matrix in single precision are as fast as those by cells.
    const bool has_tetrahedra =
      std::any_of(space.cells.begin(), space.cells.end(), [](const KernelCells &cells) {
        return cells.are_tetrahedra;
      });
    Spaces grids{{}, nodes};
    if (!has_tetrahedra)
      grids = auxiliary_grids(space, nodes);
    if (!grids.levels.empty())
      spaces.levels.emplace_back(std::move(P), std::make_unique<CellOperator<float>>(space));
    else
      {
        LA::SparseMatrix K;
        assemble(space, K);
        spaces.levels.emplace_back(std::move(P), std::move(K));
        if (has_tetrahedra)
          grids = auxiliary_grids(*spaces.levels.back().matrix, nodes);
      }
    append(std::move(grids), spaces);
  }



  void
  append_last(Spaces                             &spaces,
              std::unique_ptr<const Prolongation> P,
              LA::SparseMatrix                  &&matrix,
              const NodePositions                &nodes)
  {
    spaces.levels.emplace_back(std::move(P), std::move(matrix));
    append(auxiliary_grids(*spaces.levels.back().matrix, nodes), spaces);
  }
} // namespace Signorini
