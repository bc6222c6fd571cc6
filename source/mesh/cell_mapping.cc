// SPDX-License-Identifier: Apache-2.0
#include "mesh/cell_mapping.h"

#include "geometry/manifolds.h"
#include <signorini/parameters/raw.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  /// The vertices, lines and quadrilaterals that hang on larger cells, by their indices in the
  /// triangulation.
  template <int dim>
  struct CellMapping<dim>::Hanging
  {
    /// Find them among the locally owned and ghost cells.
    explicit Hanging(const Triangulation<dim> &triangulation);

    /// @return whether a node of a cell, in the order of FE_Q of some degree, hangs.
    bool
    has(const Cell &cell, unsigned int node, unsigned int degree) const;

    /// @return whether any node of a cell hangs.
    bool
    has_any(const Cell &cell, unsigned int degree) const;

    std::vector<bool> vertices, lines, quads;
  };



  // If a line or face of an active cell is divided, its midpoint and its parts hang on this cell.
  template <int dim>
  CellMapping<dim>::Hanging::Hanging(const Triangulation<dim> &triangulation)
    : vertices(triangulation.n_vertices(), false)
    , lines(triangulation.n_raw_lines(), false)
  {
    if constexpr (dim == 3)
      quads.resize(triangulation.n_raw_quads(), false);
    for (const auto &cell : triangulation.active_cell_iterators())
      {
        if (cell->is_artificial())
          continue;
        for (const unsigned int l : cell->line_indices())
          // Vertex 1 of the first half of a line is its midpoint.
          if (const auto line = cell->line(l); line->has_children())
            {
              vertices[line->child(0)->vertex_index(1)] = true;
              lines[line->child_index(0)] = lines[line->child_index(1)] = true;
            }
        if constexpr (dim == 3)
          for (const auto &face : cell->face_iterators())
            // Vertex 3 of the first quarter of a face is its centre, which is a vertex of all four
            // quarters.
            for (unsigned int c = 0; c < face->n_children(); ++c)
              {
                const auto child                          = face->child(c);
                vertices[face->child(0)->vertex_index(3)] = quads[child->index()] = true;
                for (const unsigned int l : child->line_indices())
                  lines[child->line_index(l)] = true;
              }
      }
  }



  template <int dim>
  bool
  CellMapping<dim>::Hanging::has(const Cell        &cell,
                                 const unsigned int node,
                                 const unsigned int degree) const
  {
    // FE_Q numbers its nodes by vertices, then lines, then quadrilaterals, then the interior, which
    // never hangs.
    const unsigned int n_vertices = cell->n_vertices(), of_line = degree - 1,
                       n_on_lines = of_line * cell->n_lines();
    if (node < n_vertices)
      return vertices[cell->vertex_index(node)];
    if (node < n_vertices + n_on_lines)
      return lines[cell->line_index((node - n_vertices) / of_line)];
    if constexpr (dim == 3)
      if (const unsigned int quad = (node - n_vertices - n_on_lines) / (of_line * of_line);
          quad < cell->n_faces())
        return quads[cell->quad_index(quad)];
    return false;
  }



  template <int dim>
  bool
  CellMapping<dim>::Hanging::has_any(const Cell &cell, const unsigned int degree) const
  {
    for (unsigned int i = 0; i < Utilities::pow(degree + 1, dim); ++i)
      if (has(cell, i, degree))
        return true;
    return false;
  }



  template <int dim>
  CellMapping<dim>::CellMapping(const unsigned int        degree,
                                std::vector<unsigned int> degree_of_material,
                                const Triangulation<dim> &triangulation,
                                const bool                has_simplices)
    : AnyCellMapping<dim>(degree,
                          has_simplices ?
                            std::make_shared<const SimplexMapping<dim>>(std::min(degree, 2u),
                                                                        degree_of_material) :
                            nullptr)
    , degree_of_material(std::move(degree_of_material))
    , shapes(std::make_shared<const FE_Q<dim>>(degree))
    , unit_nodes(shapes->get_unit_support_points())
    , moved(std::make_shared<const Moved>())
  {
    if (has_simplices && degree > 1)
      check_simplices(triangulation);
    place_hanging_nodes(triangulation);
  }



  // Edges of simplices are curved by files, circles of the scene, and transformations; what inverts
  // a cell is known only here, where all of them have acted.
  template <int dim>
  void
  CellMapping<dim>::check_simplices(const Triangulation<dim> &triangulation) const
  {
    std::string first;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (first.empty() && cell->is_locally_owned() && cell->reference_cell().is_simplex() &&
          is_inverted_simplex(this->simplices->compute_mapping_support_points(cell)))
        {
          std::ostringstream place;
          place << cell->center();
          first = place.str();
        }
    for (const std::string &of_rank :
         Utilities::MPI::all_gather(triangulation.get_communicator(), first))
      if (!of_rank.empty())
        throw SceneError(
          "Mesh: curved edges invert the cell about (" + of_rank +
          "): they are too long for its height; use smaller elements there, straight "
          "edges (Curved boundaries = none, Mid-side nodes = no), or another "
          "Transformation");
  }



  // Move hanging nodes of locally owned cells from their manifolds onto the edge or face of the
  // larger cell, and send the result to the ranks for which these are ghosts. Cells without such
  // nodes, or where the manifold is straight, are not stored.
  template <int dim>
  void
  CellMapping<dim>::place_hanging_nodes(const Triangulation<dim> &triangulation)
  {
    constexpr double       small   = 1e-10; // of the size of a cell
    constexpr double       epsilon = std::numeric_limits<double>::epsilon();
    constexpr unsigned int none    = numbers::invalid_unsigned_int;
    const MPI_Comm         comm    = triangulation.get_communicator();
    const Hanging          hanging(triangulation);
    const QGauss<dim>      rule(this->get_degree() + 1);
    auto                   now = std::make_shared<Moved>();
    const auto             add = [&](const auto &cell, const Nodes &points) {
      now->places.resize(triangulation.n_active_cells(), none);
      now->places[cell->active_cell_index()] = now->points.size();
      now->points.push_back(points);
    };
    // A cell is inverted if the determinant of its mapping is not positive at a quadrature point.
    const auto folds = [&](const Nodes &points) {
      for (const Point<dim> &unit : rule.get_points())
        {
          Tensor<2, dim> slopes;
          for (unsigned int i = 0; i < points.size(); ++i)
            slopes += outer_product(points[i] - points[0], shapes->shape_grad(i, unit));
          if (determinant(slopes) <= 0)
            return true;
        }
      return false;
    };

    // Positions are computed by the owner of each cell, which has all of its neighbours.
    bool any_folds = false;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned() && cell->reference_cell().is_hyper_cube() &&
          hanging.has_any(cell, degree_of_material.at(cell->material_id())))
        {
          const Nodes before = nodes_on_manifolds(cell), after = nodes(cell, hanging);
          double      change = 0;
          for (unsigned int i = 0; i < after.size(); ++i)
            change = std::max(change, before[i].distance(after[i]));
          // The first term is relative to the diagonal of the cell; the second is the rounding of
          // coordinates of a cell far from the origin, without which such cells would be stored for
          // nothing.
          if (change <= small * before.front().distance(before[cell->n_vertices() - 1]) +
                          16 * epsilon * before.front().norm())
            continue;
          add(cell, support_points(after));
          // A cell that is inverted on its manifolds as well is not the fault of hanging nodes.
          any_folds |= folds(now->points.back()) && !folds(support_points(before));
        }
    if (Utilities::MPI::logical_or(any_folds, comm))
      throw SceneError(
        "Mesh: cells with hanging nodes of a thin curved body would be inverted, because the edges "
        "of the larger neighbours are straight; use more cells along its circumference, or set "
        "Degree = 2 for it");
    if (!Utilities::MPI::logical_or(!now->points.empty(), comm))
      return;
    // A ghost may hang on a cell that only its owner has.
    if (Utilities::MPI::n_mpi_processes(comm) > 1)
      GridTools::exchange_cell_data_to_ghosts<Nodes, Triangulation<dim>>(
        triangulation,
        [&](const auto &cell) -> std::optional<Nodes> {
          const unsigned int place =
            now->places.empty() ? none : now->places[cell->active_cell_index()];
          if (place == none)
            return {};
          return now->points[place];
        },
        add);
    moved = now;
  }



  // Materials have either the degree of the mapping or are straight: then their vertices are
  // enough.
  template <int dim>
  typename CellMapping<dim>::Nodes
  CellMapping<dim>::nodes_on_manifolds(const Cell &cell) const
  {
    if (degree_of_material.at(cell->material_id()) == this->get_degree())
      return MappingQ<dim>::compute_mapping_support_points(cell);
    Nodes vertices;
    for (const unsigned int v : cell->vertex_indices())
      vertices.push_back(cell->vertex(v));
    return vertices;
  }



  // Nodes that hang are evaluated from the mapping of the parent, whose own nodes may hang:
  // recursion ends at the coarse cells.
  template <int dim>
  typename CellMapping<dim>::Nodes
  CellMapping<dim>::nodes(const Cell &cell, const Hanging &hanging) const
  {
    Nodes result = nodes_on_manifolds(cell);
    if (cell->level() == 0)
      return result;
    const unsigned int degree = degree_of_material.at(cell->material_id());
    Nodes              of_parent;
    for (unsigned int i = 0; i < result.size(); ++i)
      if (hanging.has(cell, i, degree))
        {
          const auto parent = cell->parent();
          if (of_parent.empty())
            of_parent = support_points(nodes(parent, hanging));
          // The position of the node in the reference cell of the parent follows from the number of
          // the child. Differences to the first node avoid cancellation far from the origin.
          unsigned int child = 0;
          while (parent->child_index(child) != cell->index())
            ++child;
          const Point<dim> place =
            GeometryInfo<dim>::child_to_cell_coordinates(unit_nodes[i], child);
          Tensor<1, dim> arm;
          for (unsigned int j = 0; j < of_parent.size(); ++j)
            arm += shapes->shape_value(j, place) * (of_parent[j] - of_parent[0]);
          result[i] = of_parent[0] + arm;
        }
    return result;
  }



  // Straight cells are interpolated from their vertices by d-linear functions.
  template <int dim>
  typename CellMapping<dim>::Nodes
  CellMapping<dim>::support_points(Nodes nodes) const
  {
    if (nodes.size() == unit_nodes.size())
      return nodes;
    Nodes points(unit_nodes.size());
    for (unsigned int i = 0; i < points.size(); ++i)
      for (unsigned int v = 0; v < nodes.size(); ++v)
        points[i] += GeometryInfo<dim>::d_linear_shape_function(unit_nodes[i], v) * nodes[v];
    return points;
  }



  template <int dim>
  std::unique_ptr<Mapping<dim>>
  CellMapping<dim>::clone() const
  {
    return std::make_unique<CellMapping>(*this);
  }



  template <int dim>
  boost::container::small_vector<Point<dim>, GeometryInfo<dim>::vertices_per_cell>
  CellMapping<dim>::get_vertices(const Cell &cell) const
  {
    if (cell->reference_cell().is_simplex())
      return AnyCellMapping<dim>::get_vertices(cell);
    const Nodes points = compute_mapping_support_points(cell);
    return {points.begin(), points.begin() + cell->n_vertices()};
  }



  // Stored positions exist for active cells with hanging nodes only; all other cells follow their
  // manifolds.
  template <int dim>
  std::vector<Point<dim>>
  CellMapping<dim>::compute_mapping_support_points(const Cell &cell) const
  {
    if (!moved->places.empty() && cell->is_active())
      if (const unsigned int place = moved->places[cell->active_cell_index()];
          place != numbers::invalid_unsigned_int)
        return moved->points[place];
    return support_points(nodes_on_manifolds(cell));
  }



  template <int dim>
  CellSimilarity::Similarity
  CellMapping<dim>::fill_fe_values(
    const Cell                                                &cell,
    const CellSimilarity::Similarity                           similarity,
    const Quadrature<dim>                                     &quadrature,
    const typename Mapping<dim>::InternalDataBase             &data,
    internal::FEValuesImplementation::MappingRelatedData<dim> &output) const
  {
    // A cell that is a translation of the previous one by its vertices may differ from it by moved
    // nodes, so that similarities are not used.
    return AnyCellMapping<dim>::fill_fe_values(
      cell, moved->places.empty() ? similarity : CellSimilarity::none, quadrature, data, output);
  }



  template class CellMapping<2>;
  template class CellMapping<3>;
} // namespace Signorini
