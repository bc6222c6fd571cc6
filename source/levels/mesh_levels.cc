#include <signorini/levels/level_vertices.h>
#include <signorini/levels/linear_space.h>
#include <signorini/levels/mesh_levels.h>
#include <signorini/linear_algebra/sparsity_pattern.h>
#include <signorini/matrix_free/cell_operator.h>

#include <algorithm>
#include <array>
#include <unordered_map>
#include <unordered_set>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    constexpr unsigned int dim = 3, n_corners = 8;

    using Index = types::global_dof_index;
    using Cell  = CellCurve::Cell;

    void
    add_cell(const Cell                         &cell,
             const std::array<Index, n_corners> &first_dofs,
             const Material                     &material,
             KernelCells                        &cells)
    {
      for (unsigned int v = 0; v < n_corners; ++v)
        {
          cells.nodes.push_back(first_dofs[v]);
          cells.points.insert(cells.points.end(),
                              cell->vertex(v).begin_raw(),
                              cell->vertex(v).end_raw());
        }
      cells.lambda.push_back(material.lambda());
      cells.mu.push_back(material.mu());
    }

    /// A mesh, as one of the levels.
    struct LevelMesh
    {
      std::vector<Cell> cells; ///< of this rank
      VertexNumbers     numbers;
      CellSpace         space;
    };

    /// Cells that this rank owns if none is finer than a level.
    std::vector<Cell>
    cells_up_to(const int level, const CellCurve &curve, const unsigned int rank)
    {
      std::vector<Cell> result;
      for (const auto &leaf : curve.leaves())
        if (leaf.cell->level() <= level)
          result.push_back(leaf.cell);
      for (const auto &place : curve.ancestors())
        if (place.cell->level() == level && curve.owner(place.position) == rank)
          result.push_back(place.cell);
      return result;
    }

    class Levels
    {
    public:
      Levels(const LinearDisplacements &linear, const Elasticity<dim> &elasticity);

      /// Collective.
      bool
      can_coarsen() const;

      /// Go to the next coarser one. Returns the prolongation from there. Collective.
      LA::SparseMatrix
      coarsen();

      const CellSpace &
      space() const
      {
        return mesh.space;
      }

      std::vector<std::vector<double>>
      modes() const;

    private:
      /// A row of the prolongation, by names of vertices.
      using Weights = std::vector<std::pair<Index, double>>;

      LevelMesh
      make_mesh(int level) const;
      void
      constrain(LevelMesh &coarse, const std::vector<Index> &known) const;
      Weights
      weights(const Cell &cell, unsigned int corner) const;
      bool
      loses_supports() const;
      void
      prolongate(const LevelMesh &coarse, LA::SparseMatrix &P) const;

      const LinearDisplacements &linear;
      const Elasticity<dim>     &elasticity;
      const LevelVertices        vertices;
      const unsigned int         n_rigid;
      int                        level;
      LevelMesh                  mesh; ///< the present one
    };

    Levels::Levels(const LinearDisplacements &linear, const Elasticity<dim> &elasticity)
      : linear(linear)
      , elasticity(elasticity)
      , vertices(linear.dofs, linear.hanging, linear.constraints)
      , n_rigid(linear.owned.size() - linear.dofs.n_dofs())
      , level(elasticity.mesh().triangulation().n_global_levels() - 1)
    {
      mesh                      = make_mesh(level);
      mesh.space.diagonal_terms = linear.terms;
    }

    LevelMesh
    Levels::make_mesh(const int at) const
    {
      LevelMesh          result;
      const MPI_Comm     comm = elasticity.mesh().communicator();
      std::vector<Index> corners, known;
      result.cells = cells_up_to(at, vertices.curve(), Utilities::MPI::this_mpi_process(comm));
      for (const Cell &cell : result.cells)
        for (unsigned int v = 0; v < n_corners; ++v)
          corners.push_back(vertices.name(cell, v));
      known = corners;
      // Those of the parents of the next finer level's cells, and what all of these hang on.
      for (const auto &place : vertices.curve().ancestors())
        if (place.cell->level() <= at)
          for (unsigned int v = 0; v < n_corners; ++v)
            known.push_back(vertices.name(place.cell, v));
      vertices.add_masters(known);
      result.numbers =
        VertexNumbers(corners, known, linear.dofs.locally_owned_dofs(), n_rigid, comm);

      CellSpace &space = result.space;
      space.comm       = comm;
      space.owned      = result.numbers.owned_dofs();
      constrain(result, known);
      space.cells.emplace_back();
      for (const Cell &cell : result.cells)
        {
          std::array<Index, n_corners> first;
          for (unsigned int v = 0; v < n_corners; ++v)
            first[v] = result.numbers.dof(vertices.name(cell, v), 0);
          add_cell(cell, first, elasticity.material(cell->material_id()), space.cells.front());
        }
      return result;
    }

    void
    Levels::constrain(LevelMesh &coarse, const std::vector<Index> &known) const
    {
      const VertexNumbers &numbers = coarse.numbers;
      IndexSet             relevant(coarse.space.owned.size());
      std::vector<Index>   dofs;
      for (const Index name : known)
        if (numbers.has(name))
          for (unsigned int c = 0; c < dim; ++c)
            dofs.push_back(numbers.dof(name, c));
      std::sort(dofs.begin(), dofs.end());
      relevant.add_indices(dofs.begin(), std::unique(dofs.begin(), dofs.end()));
      relevant.add_indices(coarse.space.owned);
      relevant.add_range(relevant.size() - n_rigid, relevant.size());
      AffineConstraints<double> &constraints = coarse.space.constraints;
      constraints.reinit(relevant);
      for (const Index name : known)
        if (numbers.has(name))
          for (unsigned int c = 0; c < dim; ++c)
            if (const auto *line = vertices.line(name + c);
                line && !constraints.is_constrained(numbers.dof(name, c)))
              {
                constraints.add_line(numbers.dof(name, c));
                for (const auto &[other, weight] : line->entries)
                  constraints.add_entry(numbers.dof(name, c),
                                        numbers.dof(other - other % dim, other % dim),
                                        weight);
              }
      for (Index i = 0; i < n_rigid; ++i)
        if (linear.constraints.is_constrained(linear.owned.size() - n_rigid + i))
          constraints.add_line(relevant.size() - n_rigid + i);
      constraints.close();
    }

    /// Of the vertices of its parent where that is on the next coarser level, or itself.
    Levels::Weights
    Levels::weights(const Cell &cell, const unsigned int corner) const
    {
      if (cell->level() < level)
        return {{vertices.name(cell, corner), 1.}};
      const Cell   parent = cell->parent();
      unsigned int child  = 0;
      while (parent->child(child) != cell)
        ++child;
      Point<dim> place; // in the parent
      for (unsigned int d = 0; d < dim; ++d)
        place[d] = ((child >> d & 1) + (corner >> d & 1)) / 2.;
      Weights result;
      for (unsigned int v = 0; v < n_corners; ++v)
        if (const double weight = GeometryInfo<dim>::d_linear_shape_function(place, v); weight > 0)
          result.emplace_back(vertices.name(parent, v), weight);
      return result;
    }

    /// Is anything held that hangs on what is not, one level coarser?
    bool
    Levels::loses_supports() const
    {
      const auto is_lost = [&](const Cell &cell, const unsigned int corner) {
        const Index   name = vertices.name(cell, corner);
        const Weights row  = weights(cell, corner);
        for (unsigned int c = 0; c < dim; ++c)
          if (const auto *line = vertices.line(name + c); row.size() > 1 && line && !line->hangs)
            for (const auto &entry : row)
              if (!vertices.line(entry.first + c))
                return true;
        return false;
      };
      bool any = false;
      for (const Cell &cell : mesh.cells)
        for (unsigned int v = 0; v < n_corners && !any; ++v)
          any = cell->level() == level && is_lost(cell, v);
      return Utilities::MPI::max(any ? 1 : 0, elasticity.mesh().communicator()) == 1;
    }

    void
    Levels::prolongate(const LevelMesh &coarse, LA::SparseMatrix &P) const
    {
      struct Entry
      {
        Index  row, column;
        double value;
      };
      std::vector<Entry>        entries;
      std::unordered_set<Index> done;
      const auto                add = [&](const Index row, const Index column, const double value) {
        if (!coarse.space.constraints.is_constrained(column))
          entries.push_back({row, column, value});
        else
          for (const auto &[other, weight] :
               *coarse.space.constraints.get_constraint_entries(column))
            entries.push_back({row, other, value * weight});
      };
      for (const Cell &cell : mesh.cells)
        for (unsigned int v = 0; v < n_corners; ++v)
          if (const Index name = vertices.name(cell, v); done.insert(name).second)
            {
              const Weights row = weights(cell, v);
              for (unsigned int c = 0; c < dim; ++c)
                if (const Index dof = mesh.numbers.dof(name, c);
                    !mesh.space.constraints.is_constrained(dof))
                  for (const auto &[vertex, weight] : row)
                    add(dof, coarse.numbers.dof(vertex, c), weight);
            }
      const IndexSet &fine = mesh.space.owned;
      for (Index i = 0; i < n_rigid; ++i)
        if (const Index dof = fine.size() - n_rigid + i;
            fine.is_element(dof) && !mesh.space.constraints.is_constrained(dof))
          entries.push_back({dof, coarse.space.owned.size() - n_rigid + i, 1.});

      // More than one weight may come to a place where vertices hang.
      std::sort(entries.begin(), entries.end(), [](const Entry &a, const Entry &b) {
        return std::tie(a.row, a.column) < std::tie(b.row, b.column);
      });
      IndexSet writable = fine;
      for (const Entry &entry : entries)
        writable.add_index(entry.row);
      LA::SparsityPattern pattern(
        fine, coarse.space.owned, writable, elasticity.mesh().communicator(), 0u);
      for (const Entry &entry : entries)
        pattern.add(entry.row, entry.column);
      pattern.compress();
      P.reinit(pattern);
      for (auto entry = entries.begin(); entry != entries.end();)
        {
          double     sum  = 0;
          const auto same = [&](const auto &other) {
            return other.row == entry->row && other.column == entry->column;
          };
          auto next = entry;
          for (; next != entries.end() && same(*next); ++next)
            sum += next->value;
          P.set(entry->row, entry->column, sum);
          entry = next;
        }
      P.compress(VectorOperation::insert);
    }

    bool
    Levels::can_coarsen() const
    {
      constexpr unsigned int few = 1000; // unknowns, which are factorised
      return level > 0 && mesh.space.owned.size() > few && !loses_supports();
    }

    LA::SparseMatrix
    Levels::coarsen()
    {
      LevelMesh        coarse = make_mesh(level - 1);
      LA::SparseMatrix P;
      prolongate(coarse, P);
      coarse.space.diagonal_terms =
        restrict_terms(mesh.space.diagonal_terms, P, coarse.space.owned, n_rigid);
      mesh = std::move(coarse);
      --level;
      return P;
    }

    std::vector<std::vector<double>>
    Levels::modes() const
    {
      std::vector<std::vector<double>> result(linear.modes.size());
      for (unsigned int m = 0; m < result.size(); ++m)
        {
          for (const Index name : mesh.numbers.owned_names())
            for (unsigned int c = 0; c < dim; ++c)
              result[m].push_back(linear.modes[m][linear.owned.index_within_set(name + c)]);
          if (mesh.space.owned.n_elements() > result[m].size())
            result[m].insert(result[m].end(),
                             linear.modes[m].end() - n_rigid,
                             linear.modes[m].end());
        }
      return result;
    }
  } // namespace



  std::unique_ptr<const StiffnessOperator>
  finest_operator(const LinearDisplacements &linear, const Elasticity<3> &elasticity)
  {
    CellSpace space;
    space.owned          = linear.owned;
    space.comm           = elasticity.mesh().communicator();
    space.diagonal_terms = linear.terms;
    space.constraints.copy_from(linear.constraints);
    space.cells.emplace_back();
    for (const auto &cell : linear.dofs.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          std::array<Index, n_corners> first;
          for (unsigned int v = 0; v < n_corners; ++v)
            first[v] = cell->vertex_dof_index(v, 0, cell->active_fe_index());
          add_cell(cell, first, elasticity.material(cell->material_id()), space.cells.front());
        }
    return std::make_unique<CellOperator<float>>(space);
  }



  Spaces
  mesh_levels(const LinearDisplacements &linear, const Elasticity<3> &elasticity)
  {
    Spaces      result;
    const auto &triangulation = elasticity.mesh().triangulation();
    if (triangulation.n_global_levels() == 1 ||
        !dynamic_cast<const parallel::distributed::Triangulation<dim> *>(&triangulation))
      return result;
    Levels levels(linear, elasticity);
    bool   is_last = !levels.can_coarsen();
    while (!is_last)
      {
        LA::SparseMatrix P = levels.coarsen(), K;
        is_last            = !levels.can_coarsen();
        if (is_last)
          {
            assemble(levels.space(), K);
            result.levels.emplace_back(std::move(P), std::move(K));
          }
        else
          result.levels.emplace_back(std::move(P),
                                     std::make_unique<CellOperator<float>>(levels.space()));
      }
    if (!result.levels.empty())
      result.modes = levels.modes();
    return result;
  }
} // namespace Signorini
