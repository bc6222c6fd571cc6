#include <signorini/mesh/generators/cells.h>
#include <signorini/mesh/generators/coinciding_nodes.h>
#include <signorini/parameters/raw.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <numeric>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    double
    shortest_edge(const std::vector<CellData<dim>> &cells, const std::vector<Point<dim>> &vertices)
    {
      double shortest = std::numeric_limits<double>::max();
      for (const auto &cell : cells)
        for (unsigned int l = 0; l < GeometryInfo<dim>::lines_per_cell; ++l)
          {
            const unsigned int a = cell.vertices[GeometryInfo<dim>::line_to_cell_vertices(l, 0)],
                               b = cell.vertices[GeometryInfo<dim>::line_to_cell_vertices(l, 1)];
            shortest             = std::min(shortest, vertices[a].distance(vertices[b]));
          }
      return shortest;
    }



    template <int dim>
    std::vector<unsigned int>
    nodes_of(const std::vector<CellData<dim>> &cells)
    {
      std::vector<unsigned int> nodes;
      for (const auto &cell : cells)
        nodes.insert(nodes.end(), cell.vertices.begin(), cell.vertices.end());
      std::sort(nodes.begin(), nodes.end());
      nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
      return nodes;
    }
  } // namespace



  template <int dim>
  CoincidingNodes<dim>::CoincidingNodes(const std::vector<CellData<dim>> &cells,
                                        const std::vector<Point<dim>>    &vertices,
                                        const double                      distance)
    : vertices(vertices)
  {
    namespace bgi      = boost::geometry::index;
    const double reach = distance > 0 ? distance : 1e-3 * shortest_edge(cells, vertices);
    std::vector<std::pair<Point<dim>, unsigned int>> nodes;
    for (const unsigned int node : nodes_of(cells))
      nodes.emplace_back(vertices[node], node);
    const auto tree = pack_rtree(nodes);
    for (const auto &[p, node] : nodes)
      {
        BoundingBox<dim> box({p, p});
        box.extend(reach);
        for (const auto &[q, other] : tree | bgi::adaptors::queried(bgi::intersects(box)))
          if (other > node && p.distance(q) <= reach)
            pairs.emplace_back(node, other);
      }
    std::sort(pairs.begin(), pairs.end());
  }



  template <int dim>
  std::vector<unsigned int>
  CoincidingNodes<dim>::representatives() const
  {
    std::vector<unsigned int> result(vertices.size());
    std::iota(result.begin(), result.end(), 0);
    for (const auto &[node, other] : pairs)
      result[other] = std::min(result[other], result[node]);
    return result;
  }



  template <int dim>
  void
  CoincidingNodes<dim>::refuse() const
  {
    if (!pairs.empty())
      throw SceneError(
        "has nodes that coincide within one body, so that its cells are not connected there: " +
        std::to_string(pairs.size()) + (pairs.size() == 1 ? " pair at " : " pairs, the first at ") +
        text_of(vertices[pairs[0].first]) +
        "; merge them by Coinciding nodes = merge, choose one side by 'Part', or say "
        "Coinciding nodes = keep if there is a crack");
  }



  template class CoincidingNodes<2>;
  template class CoincidingNodes<3>;
} // namespace Signorini
