// SPDX-License-Identifier: Apache-2.0
#include "multigrid/node_grids.h"

#include "geometry/connected.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // Of the key of a corner, for each coordinate; `zero` is the key of the origin.
    constexpr unsigned int  bits = 21;
    constexpr std::uint64_t zero = std::uint64_t(1) << (bits - 1);

    /// The nodes of a part, of this rank or of all.
    struct PartExtent
    {
      Place  low, high;
      Place  logarithms{};                ///< sum of those of distances in each direction
      double n = 0, cosine = 0, sine = 0; ///< number of nodes; sums over the phases of sizes

      PartExtent()
      {
        low.fill(std::numeric_limits<double>::max());
        high.fill(std::numeric_limits<double>::lowest());
      }

      void
      add(const PartExtent &other)
      {
        for (unsigned int d = 0; d < 3; ++d)
          {
            low[d]  = std::min(low[d], other.low[d]);
            high[d] = std::max(high[d], other.high[d]);
            logarithms[d] += other.logarithms[d];
          }
        n += other.n;
        cosine += other.cosine;
        sine += other.sine;
      }

      template <class Archive>
      void
      serialize(Archive &ar, const unsigned int)
      {
        ar &low &high &logarithms &n &cosine &sine;
      }
    };

    /// The distances of a node to its neighbours in each direction: the largest ones, without those
    /// of nodes that constraints couple over a distance; zero if it has no others.
    Place
    distances(const LA::NodeGraph      &graph,
              const std::vector<Place> &positions,
              const std::uint32_t       node,
              const unsigned int        dim)
    {
      const auto square = [&](const std::uint32_t other) {
        double sum = 0;
        for (unsigned int d = 0; d < dim; ++d)
          sum += std::pow(positions[other][d] - positions[node][d], 2);
        return sum;
      };
      std::vector<double> squares;
      for (const std::uint32_t *other = graph.begin(node); other != graph.end(node); ++other)
        squares.push_back(square(*other));
      if (squares.empty())
        return {};
      // Fewer than three fifths are far away; of the cells of a needle a third are close.
      const auto typical = squares.begin() + squares.size() * 2 / 5;
      std::nth_element(squares.begin(), typical, squares.end());
      const double limit = 4 * *typical;
      Place        result{};
      for (const std::uint32_t *other = graph.begin(node); other != graph.end(node); ++other)
        if (square(*other) <= limit)
          for (unsigned int d = 0; d < dim; ++d)
            result[d] = std::max(result[d], std::abs(positions[*other][d] - positions[node][d]));
      // Neighbours may all be in one line or plane.
      const double most = *std::max_element(result.begin(), result.end());
      for (unsigned int d = 0; d < dim; ++d)
        result[d] = std::max(result[d], 1e-3 * most);
      return result;
    }

    /// The binary logarithm of the geometric mean.
    double
    size_of(const Place &distances, const unsigned int dim)
    {
      double sum = 0;
      for (unsigned int d = 0; d < dim; ++d)
        sum += std::log2(distances[d]);
      return sum / dim;
    }

    /// The part of each local node, by the largest global number of its nodes; no_part for nodes
    /// that are supported, or kept on all levels. Collective.
    std::vector<double>
    label_parts(const LA::NodeGraph &graph)
    {
      Connected           sets(graph.size());
      std::vector<double> labels(graph.size(), GridNodes::no_part);
      for (std::uint32_t node = 0; node < graph.size(); ++node)
        if (graph.is_free(node) && !graph.is_kept(node))
          labels[node] = graph.global(node);
      for (std::uint32_t node = 0; node < graph.size(); ++node)
        if (labels[node] != GridNodes::no_part)
          for (const std::uint32_t *other = graph.begin(node); other != graph.end(node); ++other)
            if (labels[*other] != GridNodes::no_part)
              sets.connect(node, *other);
      enlarge(graph, sets, 1, labels);
      return labels;
    }

    /// The extents of all parts, by label. Collective. @param around see distances(); @param sizes
    /// their logarithms
    std::map<double, PartExtent>
    measure_parts(const LA::NodeGraph       &graph,
                  const std::vector<Place>  &positions,
                  const std::vector<Place>  &around,
                  const std::vector<double> &labels,
                  const std::vector<double> &sizes)
    {
      std::map<double, PartExtent> parts;
      for (std::uint32_t node = 0; node < graph.n_owned(); ++node)
        if (labels[node] != GridNodes::no_part)
          {
            PartExtent alone;
            alone.low = alone.high = positions[node];
            for (unsigned int d = 0; d < graph.n_components; ++d)
              alone.logarithms[d] = std::log2(around[node][d]) - sizes[node];
            // Sizes that differ by powers of two have the same phase; the mean direction of the
            // phases is that of most sizes.
            const double phase = 2 * numbers::PI * sizes[node];
            alone.n            = 1;
            alone.cosine       = std::cos(phase);
            alone.sine         = std::sin(phase);
            parts[labels[node]].add(alone);
          }
      std::map<double, PartExtent> all;
      for (const auto &of_rank : Utilities::MPI::all_gather(graph.comm, parts))
        for (const auto &[label, extent] : of_rank)
          all[label].add(extent);
      return all;
    }
  } // namespace



  // Parts are known by the largest global number of their nodes until they are numbered.
  std::pair<std::vector<PartGrid>, GridNodes>
  make_grids(const LA::NodeGraph &graph, const std::vector<Place> &positions)
  {
    const unsigned int  dim = graph.n_components;
    GridNodes           nodes(graph.n_owned());
    std::vector<double> labels = label_parts(graph);
    std::vector<Place>  around(graph.n_owned());
    // Nodes that are all at one place have no grid.
    for (std::uint32_t node = 0; node < graph.n_owned(); ++node)
      {
        around[node] = distances(graph, positions, node, dim);
        if (around[node][0] == 0)
          labels[node] = GridNodes::no_part;
        else
          nodes.sizes[node] = size_of(around[node], dim);
      }
    const std::map<double, PartExtent> all =
      measure_parts(graph, positions, around, labels, nodes.sizes);

    // The spacing of a part: the mean shape of the boxes around nodes, and a size with the mean
    // phase.
    std::vector<PartGrid>    grids;
    std::map<double, double> numbers;
    std::vector<double>      units;
    std::vector<PartExtent>  extents;
    for (const auto &[label, extent] : all)
      {
        numbers[label] = grids.size();
        units.push_back(std::atan2(extent.sine, extent.cosine) / (2 * numbers::PI));
        PartGrid grid;
        grid.origin = extent.low;
        for (unsigned int d = 0; d < dim; ++d)
          grid.spacing[d] = std::exp2(extent.logarithms[d] / extent.n + units.back());
        grids.push_back(grid);
        extents.push_back(extent);
      }
    // The smallest size of each part becomes zero.
    std::vector<double> least(grids.size(), std::numeric_limits<double>::max());
    for (std::uint32_t node = 0; node < graph.n_owned(); ++node)
      {
        const auto known =
          labels[node] == GridNodes::no_part ? numbers.end() : numbers.find(labels[node]);
        nodes.parts[node] = known == numbers.end() ? GridNodes::no_part : known->second;
        if (known != numbers.end())
          {
            const unsigned int part = known->second;
            nodes.sizes[node]       = std::round(nodes.sizes[node] - units[part]);
            least[part]             = std::min(least[part], nodes.sizes[node]);
          }
      }
    if (!least.empty())
      Utilities::MPI::min(std::vector<double>(least), graph.comm, least);
    // Keys of corners have 21 bits for each coordinate: a part has at most 2^18 spacings in each
    // direction, so that there is room for grids that reach beyond it. Nodes that are closer than
    // that have the smallest size as well.
    for (unsigned int part = 0; part < grids.size(); ++part)
      {
        const PartExtent &extent = extents[part];
        for (unsigned int d = 0; d < dim; ++d)
          while ((extent.high[d] - extent.low[d]) /
                   (grids[part].spacing[d] * std::exp2(least[part])) >
                 zero / 4)
            ++least[part];
        for (unsigned int d = 0; d < dim; ++d)
          grids[part].spacing[d] *= std::exp2(least[part]);
      }
    for (std::uint32_t node = 0; node < graph.n_owned(); ++node)
      if (nodes.parts[node] != GridNodes::no_part)
        {
          const PartGrid &grid = grids[nodes.parts[node]];
          nodes.sizes[node]    = std::max(0., nodes.sizes[node] - least[nodes.parts[node]]);
          for (unsigned int d = 0; d < dim; ++d)
            nodes.places[node][d] = (positions[node][d] - grid.origin[d]) / grid.spacing[d];
        }
    return {grids, nodes};
  }



  unsigned int
  coarsen(PartGrid &grid, const unsigned int dim)
  {
    // Point smoothers reduce errors in the directions in which nodes are close; in the others they
    // need no coarser grid yet.
    const auto distance = [&](const unsigned int d) { return grid.step[d] * grid.spacing[d]; };
    double     least    = distance(0);
    for (unsigned int d = 1; d < dim; ++d)
      least = std::min(least, distance(d));
    std::array<bool, 3> is_close{};
    for (unsigned int d = 0; d < dim; ++d)
      is_close[d] = distance(d) <= 1.5 * least;
    unsigned int factor = 1;
    for (unsigned int d = 0; d < dim; ++d)
      if (is_close[d])
        {
          grid.step[d] *= 2;
          factor *= 2;
        }
    return factor;
  }



  unsigned int
  find_corners(const Place               &place,
               const double               size,
               const PartGrid            &grid,
               const unsigned int         dim,
               std::array<GridCorner, 8> &corners)
  {
    constexpr double rounding = 1e-6;
    unsigned int     n        = 1;
    corners[0]                = {0, 1.};
    for (unsigned int d = 0; d < dim; ++d)
      {
        // At most as large as keys admit.
        const std::int64_t step =
          std::min(grid.step[d] << static_cast<int>(size), std::int64_t(zero) / 2);
        const double at   = place[d] / step;
        const double low  = std::floor(at + rounding);
        const double part = at - low < rounding ? 0 : at - low;
        const auto   key  = [&](const double index) {
          return static_cast<std::uint64_t>(static_cast<std::int64_t>(index) * step + zero);
        };
        for (unsigned int k = 0; k < n; ++k)
          {
            corners[n + k] = {corners[k].key << bits | key(low + 1), corners[k].weight * part};
            corners[k]     = {corners[k].key << bits | key(low), corners[k].weight * (1 - part)};
          }
        if (part > 0)
          n *= 2;
      }
    std::sort(corners.begin(), corners.begin() + n, [](const GridCorner &a, const GridCorner &b) {
      return a.key < b.key;
    });
    return n;
  }



  Place
  place_of(std::uint64_t key, const unsigned int dim)
  {
    Place result{};
    for (unsigned int d = dim; d-- > 0; key >>= bits)
      result[d] = double(static_cast<std::int64_t>(key & (2 * zero - 1)) - std::int64_t(zero));
    return result;
  }



  // Within sets directly; the copies of each item on several ranks until nothing changes.
  void
  enlarge(const LA::NodeGraph &graph,
          Connected           &sets,
          const unsigned int   stride,
          std::vector<double> &values)
  {
    const bool          is_alone = Utilities::MPI::n_mpi_processes(graph.comm) == 1;
    std::vector<double> column(graph.size());
    for (bool changes = true; changes;)
      {
        for (std::uint32_t i = 0; i < values.size(); ++i)
          values[sets.first_of(i)] = std::max(values[sets.first_of(i)], values[i]);
        for (std::uint32_t i = 0; i < values.size(); ++i)
          values[i] = values[sets.first_of(i)];
        if (is_alone)
          return;
        changes = false;
        for (unsigned int k = 0; k < stride; ++k)
          {
            for (std::uint32_t node = 0; node < graph.size(); ++node)
              column[node] = values[node * stride + k];
            graph.enlarge(column);
            for (std::uint32_t node = 0; node < graph.size(); ++node)
              {
                changes                   = changes || column[node] > values[node * stride + k];
                values[node * stride + k] = column[node];
              }
          }
        changes = Utilities::MPI::max(changes ? 1 : 0, graph.comm) == 1;
      }
  }
} // namespace Signorini
