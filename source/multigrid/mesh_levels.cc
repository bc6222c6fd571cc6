// SPDX-License-Identifier: Apache-2.0
#include "linear_algebra/smoothed_aggregation.h"
#include "matrix_free/cell_operator.h"
#include "multigrid/auxiliary_grids.h"
#include "multigrid/interpolation_transfer.h"
#include "multigrid/levels.h"
#include "multigrid/linear_space.h"

#include <algorithm>
#include <array>
#include <optional>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    constexpr unsigned int dim = 3, n_corners = 8;

    using Index = types::global_dof_index;
    using Cell  = SpaceFillingCurve::Cell;

    /// Add the corners and the moduli of a cell.
    void
    add_material(const Cell &cell, const Material &material, KernelCells &cells)
    {
      for (const unsigned int v : cell->vertex_indices())
        cells.points.insert(cells.points.end(),
                            cell->vertex(v).begin_raw(),
                            cell->vertex(v).end_raw());
      cells.lambda.push_back(material.lambda());
      cells.mu.push_back(material.mu());
    }

    using PlacedCell = SpaceFillingCurve::PlacedCell;

    /// Call act(place) for the leaves of this rank up to `level`, and for the cells of that level
    /// that have finer leaves on this rank (others may visit them too).
    template <typename Action>
    void
    for_each_cell(const int level, const SpaceFillingCurve &curve, const Action &act)
    {
      for (const PlacedCell &leaf : curve.leaves())
        if (leaf.cell->level() <= level)
          act(leaf);
      for (const PlacedCell &cell_on_curve : curve.ancestors())
        if (cell_on_curve.cell->level() == level)
          act(cell_on_curve);
    }

    /// The construction of the levels below the finest mesh by global coarsening: on each level all
    /// cells of the finest refinement level are replaced by their parents (doc/theory, 7.1). Starts
    /// on the finest mesh; coarsen() proceeds by one level. Refers to its arguments.
    class Levels
    {
    public:
      Levels(const LinearDisplacements &linear, const Elasticity<dim> &elasticity);

      /// True if there is a coarser mesh, the present one is too large for a factorisation, and no
      /// constraint would be lost on the coarser one. Collective.
      bool
      can_coarsen() const;

      /// Proceed to the next coarser level. Collective. @return the prolongation from there to the
      /// level before
      std::unique_ptr<const Prolongation>
      coarsen();

      /// The space of the present level. Valid after coarsen().
      const CellSpace &
      space() const
      {
        return present;
      }

      /// The positions of the nodes of the present level.
      NodePositions
      nodes() const;

    private:
      /// The vertices of the next level, by name, of which a vertex of the present one is the mean.
      struct Parents
      {
        std::array<Index, n_corners> names;
        unsigned int                 n = 0;
      };

      VertexNumbers
      number_vertices(int level, const std::vector<Index> &known) const;
      CellSpace
      make_space(int level, const std::vector<Index> &known, const VertexNumbers &numbers) const;
      void
      constrain(const std::vector<Index> &known, const VertexNumbers &, CellSpace &) const;
      std::vector<Index>
      known_names(int level) const;
      Parents
      parents(const PlacedCell &cell, unsigned int corner) const;
      bool
      loses_constraints() const;
      InterpolationTransfer::Nodes
      nodes_on(const VertexNumbers &coarse) const;

      const LinearDisplacements   &linear;
      const Elasticity<dim>       &elasticity;
      const MPI_Comm               comm;
      const LevelVertices          vertices;
      std::optional<LevelTangents> tangents; ///< none: see LinearDisplacements
      const unsigned int           n_rigid;
      int                          level;

      // Data of the present level.
      VertexNumbers numbers;
      /// Empty on the finest mesh.
      CellSpace present;
    };

    Levels::Levels(const LinearDisplacements &linear, const Elasticity<dim> &elasticity)
      : linear(linear)
      , elasticity(elasticity)
      , comm(elasticity.mesh().communicator())
      , vertices(linear.dofs, linear.hanging, linear.constraints)
      , n_rigid(linear.owned.size() - linear.dofs.n_dofs())
      , level(elasticity.mesh().triangulation().n_global_levels() - 1)
      , numbers(linear.owned)
    {
      if (linear.tangents)
        tangents.emplace(*linear.tangents, vertices.curve(), comm);
    }

    // The names of the corners of this rank's cells, and of vertices in their constraints.
    std::vector<Index>
    Levels::known_names(const int at) const
    {
      // The list has duplicates, as a vertex belongs to several cells; the numbering and the
      // constraints sort them out.
      std::vector<Index> known;
      for_each_cell(at, vertices.curve(), [&](const PlacedCell &cell_on_curve) {
        for (unsigned int v = 0; v < n_corners; ++v)
          known.push_back(vertices.name(cell_on_curve.cell, v));
      });
      vertices.add_masters(known);
      return known;
    }

    // Number the vertices of a level: each cell is counted by its owner only.
    VertexNumbers
    Levels::number_vertices(const int at, const std::vector<Index> &known) const
    {
      const unsigned int rank = Utilities::MPI::this_mpi_process(comm);
      std::vector<Index> corners;
      for_each_cell(at, vertices.curve(), [&](const PlacedCell &cell_on_curve) {
        if (vertices.curve().owner(cell_on_curve.position) == rank)
          for (unsigned int v = 0; v < n_corners; ++v)
            corners.push_back(vertices.name(cell_on_curve.cell, v));
      });
      return VertexNumbers(corners, known, linear.dofs.locally_owned_dofs(), n_rigid, comm);
    }

    // The space of a level: numbering, constraints, and the cells that this rank owns with their
    // tangents or moduli. The operator of a level is its own discretisation.
    CellSpace
    Levels::make_space(const int                 at,
                       const std::vector<Index> &known,
                       const VertexNumbers      &of_level) const
    {
      const unsigned int rank = Utilities::MPI::this_mpi_process(comm);
      CellSpace          space;
      space.comm  = comm;
      space.owned = of_level.owned_dofs();
      constrain(known, of_level, space);
      space.cells.emplace_back();
      for_each_cell(at, vertices.curve(), [&](const PlacedCell &cell_on_curve) {
        if (vertices.curve().owner(cell_on_curve.position) != rank)
          return;
        KernelCells &cells = space.cells.front();
        for (unsigned int v = 0; v < n_corners; ++v)
          cells.nodes.push_back(of_level.dof(vertices.name(cell_on_curve.cell, v), 0));
        if (tangents)
          cells.tangents.push_back(tangents->of(cell_on_curve.cell));
        else
          add_material(cell_on_curve.cell,
                       elasticity.material(cell_on_curve.cell->material_id()),
                       cells);
      });
      return space;
    }

    // The constraints of vertices are those on the finest mesh, by name: a vertex that hangs or is
    // supported there does so on all levels on which it exists.
    void
    Levels::constrain(const std::vector<Index> &known,
                      const VertexNumbers      &of_level,
                      CellSpace                &space) const
    {
      // Constraints are stored for vertices of this rank and for those of its cells that other
      // ranks own: kernels resolve both.
      IndexSet           relevant = space.owned;
      std::vector<Index> others;
      for (const Index name : known)
        if (of_level.has(name) && !space.owned.is_element(of_level.dof(name, 0)))
          for (unsigned int c = 0; c < dim; ++c)
            others.push_back(of_level.dof(name, c));
      std::sort(others.begin(), others.end());
      relevant.add_indices(others.begin(), std::unique(others.begin(), others.end()));
      relevant.add_range(relevant.size() - n_rigid, relevant.size());
      AffineConstraints<double> &constraints = space.constraints;
      constraints.reinit(relevant);
      for (const Index name : known)
        for (unsigned int c = 0; c < dim; ++c)
          if (const auto *line = vertices.line(name + c);
              line && of_level.has(name) && !constraints.is_constrained(of_level.dof(name, c)))
            {
              constraints.add_line(of_level.dof(name, c));
              // Vertices to which equations refer may exist on finer levels only.
              for (const auto &[other, weight] : line->entries)
                if (of_level.has(other - other % dim))
                  constraints.add_entry(of_level.dof(name, c),
                                        of_level.dof(other - other % dim, other % dim),
                                        weight);
            }
      // Rigid bodies have no cells and are the same on all levels; prescribed components are
      // constrained on each of them.
      for (Index i = 0; i < n_rigid; ++i)
        if (linear.constraints.is_constrained(linear.owned.size() - n_rigid + i))
          constraints.add_line(relevant.size() - n_rigid + i);
      constraints.close();
    }

    // A cell of the present level is replaced by its parent: its corner is a corner of the parent,
    // or the middle of an edge, face or the whole. Corners of coarser cells stay.
    Levels::Parents
    Levels::parents(const PlacedCell &cell_on_curve, const unsigned int corner) const
    {
      Parents result;
      if (cell_on_curve.cell->level() < level)
        result.names[result.n++] = vertices.name(cell_on_curve.cell, corner);
      else
        {
          // By direction: on the same side, the coordinate of the parent's corner; else the middle.
          // Bit d of a corner or child number is its side in direction d. A bit that child and
          // corner have in common is on the boundary of the parent (no bit of `middle`); where they
          // differ, the corner is at the middle between both sides, and corners v of the parent on
          // either side count. So 1, 2, 4 or 8 corners remain.
          const Cell         parent = cell_on_curve.cell->parent();
          const unsigned int child  = SpaceFillingCurve::child_number(cell_on_curve),
                             middle = child ^ corner;
          for (unsigned int v = 0; v < n_corners; ++v)
            if (((v ^ corner) & ~middle) == 0)
              result.names[result.n++] = vertices.name(parent, v);
        }
      return result;
    }

    // True on all ranks if a supported vertex of the present level would depend on coarser vertices
    // that are not supported: the coarser level could not represent the support. Collective.
    bool
    Levels::loses_constraints() const
    {
      const unsigned int rank    = Utilities::MPI::this_mpi_process(comm);
      const auto         is_lost = [&](const PlacedCell &cell_on_curve, const unsigned int corner) {
        // Only supports are examined, not hanging nodes; a vertex that exists on the coarser level
        // (one parent) keeps its own constraint.
        const Index name = vertices.name(cell_on_curve.cell, corner);
        for (unsigned int c = 0; c < dim; ++c)
          if (const auto *line = vertices.line(name + c); line && !line->hangs)
            {
              const Parents of = parents(cell_on_curve, corner);
              for (unsigned int k = 0; k < of.n && of.n > 1; ++k)
                if (!vertices.line(of.names[k] + c))
                  return true;
            }
        return false;
      };
      bool any = false;
      for_each_cell(level, vertices.curve(), [&](const PlacedCell &cell_on_curve) {
        if (!any && cell_on_curve.cell->level() == level &&
            vertices.curve().owner(cell_on_curve.position) == rank)
          for (unsigned int v = 0; v < n_corners && !any; ++v)
            any = is_lost(cell_on_curve, v);
      });
      return Utilities::MPI::max(any ? 1 : 0, comm) == 1;
    }

    // The vertices of the present level that this rank owns, each once, as means of vertices of the
    // next coarser level.
    InterpolationTransfer::Nodes
    Levels::nodes_on(const VertexNumbers &coarse) const
    {
      // A vertex is visited from each of its cells and written once, by the rank that owns its name
      // on the finest mesh. Any of its cells gives the same result: it is a corner, or the middle
      // of the same edge or face, of the cells of the coarser level.
      const LA::OwnRange           own(linear.dofs.locally_owned_dofs());
      InterpolationTransfer::Nodes nodes;
      std::vector<bool>            is_done(own.size() / dim, false);
      for_each_cell(level, vertices.curve(), [&](const PlacedCell &cell_on_curve) {
        for (unsigned int v = 0; v < n_corners; ++v)
          if (const Index name = vertices.name(cell_on_curve.cell, v);
              own.has(name) && !is_done[own.local_index(name) / dim])
            {
              is_done[own.local_index(name) / dim] = true;
              Parents of                           = parents(cell_on_curve, v);
              for (unsigned int k = 0; k < of.n; ++k)
                of.names[k] = coarse.dof(of.names[k], 0);
              nodes.add(numbers.dof(name, 0), of.names.data(), of.n);
            }
      });
      return nodes;
    }

    bool
    Levels::can_coarsen() const
    {
      return level > 0 && numbers.owned_dofs().size() > LA::factorised_size && !loses_constraints();
    }

    std::unique_ptr<const Prolongation>
    Levels::coarsen()
    {
      // The finest mesh has no CellSpace of its own here, but the data of `linear`. Everything of
      // the coarser level is made before the present one is replaced, because the transfer refers
      // to both.
      const bool               is_finest = present.owned.size() == 0;
      const std::vector<Index> known     = known_names(level - 1);
      VertexNumbers            below     = number_vertices(level - 1, known);
      CellSpace                coarse    = make_space(level - 1, known, below);
      const LA::Vector        &terms     = is_finest ? linear.terms : present.diagonal_terms;
      auto                     P         = std::make_unique<InterpolationTransfer>(
        nodes_on(below),
        InterpolationTransfer::Side{numbers.owned_dofs(),
                                    is_finest ? linear.constraints : present.constraints},
        InterpolationTransfer::Side{coarse.owned, coarse.constraints},
        n_rigid,
        comm);
      coarse.diagonal_terms = restrict_terms(terms, *P, coarse.owned, n_rigid);
      present               = std::move(coarse);
      numbers               = std::move(below);
      --level;
      return P;
    }

    // Those of the finest mesh that this level has.
    NodePositions
    Levels::nodes() const
    {
      NodePositions result = linear.nodes;
      result.coordinates.clear();
      for (const Index name : numbers.owned_names())
        {
          const auto first = linear.nodes.coordinates.begin() + linear.owned.index_within_set(name);
          result.coordinates.insert(result.coordinates.end(), first, first + dim);
        }
      result.coordinates.resize(present.owned.n_elements(), 0.);
      return result;
    }
  } // namespace



  CellSpace
  finest_space(const LinearDisplacements &linear, const Elasticity<3> &elasticity)
  {
    CellSpace space;
    space.owned          = linear.owned;
    space.comm           = elasticity.mesh().communicator();
    space.diagonal_terms = linear.terms;
    space.constraints.copy_from(linear.constraints);
    // Hexahedra, then tetrahedra if there are any.
    space.cells.resize(elasticity.mesh().has_simplices() ? 2 : 1);
    space.cells.back().are_tetrahedra = elasticity.mesh().has_simplices();
    for (const auto &cell : linear.dofs.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          KernelCells &cells = space.cells[cell->reference_cell().is_simplex() ? 1 : 0];
          // Corners in the order of deal.II are those of kernels of degree one, for hexahedra
          // lexicographic.
          for (const unsigned int v : cell->vertex_indices())
            cells.nodes.push_back(cell->vertex_dof_index(v, 0, cell->active_fe_index()));
          if (linear.tangents)
            cells.tangents.push_back((*linear.tangents)[cell->active_cell_index()]);
          else
            add_material(cell, elasticity.material(cell->material_id()), cells);
        }
    return space;
  }



  // Levels from finer to coarser, with grids below the last one. Collective.
  Spaces
  mesh_levels(const LinearDisplacements &linear, const Elasticity<3> &elasticity)
  {
    Spaces      result;
    const auto &triangulation = elasticity.mesh().triangulation();
    // A mesh that was never refined has no coarser one, and meshes that are not distributed have no
    // space-filling curve.
    if (triangulation.n_global_levels() == 1 ||
        !dynamic_cast<const parallel::distributed::Triangulation<dim> *>(&triangulation))
      return result;
    Levels levels(linear, elasticity);
    bool   is_last = !levels.can_coarsen();
    while (!is_last)
      {
        std::unique_ptr<const Prolongation> P = levels.coarsen();
        is_last                               = !levels.can_coarsen();
        if (is_last)
          // Whether a level is the last one is known only after the next one was tried.
          append_last(result, std::move(P), levels.space(), levels.nodes());
        else
          result.levels.emplace_back(std::move(P),
                                     std::make_unique<CellOperator<float>>(levels.space()));
      }
    return result;
  }
} // namespace Signorini
