// SPDX-License-Identifier: Apache-2.0
#include "multigrid/linear_space.h"

#include "base/compatibility.h"
#include "linear_algebra/sparsity_pattern.h"
#include "linear_algebra/values.h"
#include "multigrid/interpolation_transfer.h"
#include "solid/cell_nodes.h"

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/fe_system.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// A sparse row with few entries, each degree of freedom once.
    using Row = std::vector<std::pair<types::global_dof_index, double>>;

    /// Add to an entry of a row, or create it.
    void
    add_entry(const types::global_dof_index dof, const double value, Row &row)
    {
      const auto known =
        std::find_if(row.begin(), row.end(), [&](const auto &entry) { return entry.first == dof; });
      if (known != row.end())
        known->second += value;
      else
        row.emplace_back(dof, value);
    }

    /// The vector-valued elements of degree one: of hypercubes, then of simplices, those that
    /// bodies have.
    template <int dim>
    hp::FECollection<dim>
    linear_elements(const Mesh<dim> &mesh)
    {
      hp::FECollection<dim> result;
      if (mesh.has_hypercubes())
        result.push_back(FESystem<dim>(FE_Q<dim>(1), dim));
      if (mesh.has_simplices())
        result.push_back(FESystem<dim>(FE_SimplexP<dim>(1), dim));
      return result;
    }
  } // namespace



  // The space of degree one on the same mesh with its own numbering, hanging nodes and supports.
  // Collective.
  template <int dim>
  LinearSpace<dim>::LinearSpace(const Elasticity<dim> &fine)
    : elements(linear_elements(fine.mesh()))
    , dofs(fine.mesh().triangulation())
  {
    if (elements.size() > 1)
      for (const auto &cell : dofs.active_cell_iterators())
        if (cell->is_locally_owned())
          cell->set_active_fe_index(cell->reference_cell().is_simplex() ? 1 : 0);
    dofs.distribute_dofs(elements);
    number(fine);
    find_vertices_of_equations(fine);
    Compatibility::reinit(constraints, owned, relevant);
    Compatibility::reinit(hanging, owned, relevant);
    DoFTools::make_hanging_node_constraints(dofs, hanging);
    hanging.close();
    constraints.merge(hanging);
    constrain_vertices(fine);
    constrain_rigid_bodies(fine);
    constraints.close();
  }

  // Degrees of freedom of rigid bodies follow those of the mesh, as in the fine space, with the
  // same owner.
  template <int dim>
  void
  LinearSpace<dim>::number(const Elasticity<dim> &fine)
  {
    // The rigid degrees of freedom are owned by one rank and relevant on all, as their motion
    // enters contact rows anywhere.
    const auto n_rigid = fine.owned().size() - fine.dof_handler().n_dofs(), n = dofs.n_dofs();
    owned = relevant = IndexSet(n + n_rigid);
    owned.add_indices(dofs.locally_owned_dofs());
    relevant.add_indices(DoFTools::extract_locally_relevant_dofs(dofs));
    relevant.add_range(n, n + n_rigid);
    if (n_rigid > 0 && fine.owned().is_element(fine.dof_handler().n_dofs()))
      owned.add_range(n, n + n_rigid);
  }

  // The vertices of constraint equations, from the ranks that own them: any rank may have a vertex
  // that depends on them. Collective.
  template <int dim>
  void
  LinearSpace<dim>::find_vertices_of_equations(const Elasticity<dim> &fine)
  {
    const ConstrainedNodes<dim> &nodes = fine.nodes_of_equations();
    if (nodes.empty())
      return;
    std::vector<std::pair<types::global_dof_index, types::global_dof_index>> found;
    for (const auto &cell : fine.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const typename DoFHandler<dim>::active_cell_iterator own(&dofs.get_triangulation(),
                                                                   cell->level(),
                                                                   cell->index(),
                                                                   &dofs);
          for (const unsigned int v : cell->vertex_indices())
            if (const auto first = cell->vertex_dof_index(v, 0, cell->active_fe_index());
                nodes.count(first) > 0)
              for (unsigned int c = 0; c < dim; ++c)
                found.emplace_back(cell->vertex_dof_index(v, c, cell->active_fe_index()),
                                   own->vertex_dof_index(v, c, own->active_fe_index()));
        }
    for (const auto &of_rank : Utilities::MPI::all_gather(fine.mesh().communicator(), found))
      of_equations.insert(of_rank.begin(), of_rank.end());
    for (const auto &[dof, own] : of_equations)
      relevant.add_index(own);
  }

  // Vertices are constrained as the nodes of the fine space there. Constraints of other nodes
  // cannot be represented in general, see CoarseConstraintPenalty. Values are zero: a level
  // corrects an error.
  template <int dim>
  void
  LinearSpace<dim>::constrain_vertices(const Elasticity<dim> &fine)
  {
    const AffineConstraints<double>                           &of_fine = fine.constraints();
    std::vector<types::global_dof_index>                       indices, fine_indices;
    std::map<types::global_dof_index, types::global_dof_index> coarse =
      of_equations; // of fine ones
    for (const auto &cell : fine.dof_handler().active_cell_iterators())
      if (!cell->is_artificial())
        {
          const typename DoFHandler<dim>::active_cell_iterator own(&dofs.get_triangulation(),
                                                                   cell->level(),
                                                                   cell->index(),
                                                                   &dofs);
          read_indices<dim>(own, indices);
          read_indices<dim>(cell, fine_indices);
          for (const unsigned int v : cell->vertex_indices())
            for (unsigned int c = 0; c < dim; ++c)
              {
                // The first nodes of a cell in deal.II are its vertices, so that node v of the fine
                // element is vertex v. All components of a supported vertex are registered, because
                // inclined supports refer to its other components.
                const auto dof = fine_indices[cell->get_fe().component_to_system_index(c, v)];
                if (of_fine.is_constrained(dof) && !fine.hanging_nodes().is_constrained(dof))
                  for (unsigned int d = 0; d < dim; ++d)
                    coarse[fine_indices[cell->get_fe().component_to_system_index(d, v)]] =
                      indices[own->get_fe().component_to_system_index(d, v)];
              }
        }
    // Constraints are copied with their weights; entries at nodes that are no vertices have no
    // counterpart and are dropped.
    for (const auto &[dof, own] : coarse)
      if (of_fine.is_constrained(dof) && !constraints.is_constrained(own))
        {
          constraints.add_line(own);
          for (const auto &[other, weight] : *of_fine.get_constraint_entries(dof))
            if (const auto known = coarse.find(other); known != coarse.end())
              constraints.add_entry(own, known->second, weight);
        }
  }

  // Prescribed motions of rigid bodies are constrained on all levels.
  template <int dim>
  void
  LinearSpace<dim>::constrain_rigid_bodies(const Elasticity<dim> &fine)
  {
    for (auto i = fine.dof_handler().n_dofs(); i < fine.owned().size(); ++i)
      if (fine.constraints().is_constrained(i))
        constraints.add_line(i - fine.dof_handler().n_dofs() + dofs.n_dofs());
  }



  namespace
  {
    /// The interpolation of the displacement of degree one at the nodes of a cell of the fine
    /// space, as rows over the degrees of freedom at vertices.
    template <int dim>
    class NodeRows
    {
    public:
      explicit NodeRows(const LinearSpace<dim> &space)
        : space(space)
      {}

      /// row += factor times the displacement of degree of freedom i of a cell with element fe.
      /// @param vertices the cell's degrees of freedom in the space of degree one
      void
      add(const FiniteElement<dim>                   &fe,
          const unsigned int                          i,
          const double                                factor,
          const std::vector<types::global_dof_index> &vertices,
          Row                                        &row) const
      {
        const auto [component, node] = fe.system_to_component_index(i);
        const Point<dim> &place      = fe.base_element(0).unit_support_point(node);
        for (const unsigned int v : fe.reference_cell().vertex_indices())
          if (const double value = fe.reference_cell().d_linear_shape_function(place, v);
              // The multilinear functions at nodes are products of 0, 1/2 and 1 for degree two, and
              // vanish at vertices of other sides.
              std::abs(value) > 1e-14)
            // The components of a vertex follow each other, vertex by vertex, in all elements.
            add_resolved(vertices[v * dim + component], factor * value, row);
      }

    private:
      /// Add an entry at a vertex, or entries at those that constrain it.
      void
      add_resolved(const types::global_dof_index dof, const double value, Row &row) const
      {
        if (const auto *line = space.constraints.get_constraint_entries(dof))
          for (const auto &[other, weight] : *line)
            add_entry(other, weight * value, row);
        else
          add_entry(dof, value, row);
      }

      const LinearSpace<dim> &space;
    };

    /// Call visit(cell, i, fine indices of the cell, indices of degree one) for each locally owned
    /// degree of freedom of the mesh once, where i is its number in the cell.
    template <int dim, typename Visitor>
    void
    visit_nodes(const Elasticity<dim> &fine, const LinearSpace<dim> &space, const Visitor &visit)
    {
      // Degrees of freedom that several cells share are visited in the first of them. The cell of
      // degree one with the same level and index has the vertices in the same order.
      std::vector<bool>                    is_done(fine.owned().n_elements(), false);
      std::vector<types::global_dof_index> indices, vertices;
      for (const auto &cell : fine.dof_handler().active_cell_iterators())
        if (cell->is_locally_owned())
          {
            const typename DoFHandler<dim>::active_cell_iterator own(
              &space.dofs.get_triangulation(), cell->level(), cell->index(), &space.dofs);
            read_indices<dim>(cell, indices);
            read_indices<dim>(own, vertices);
            for (unsigned int i = 0; i < indices.size(); ++i)
              if (fine.owned().is_element(indices[i]))
                {
                  const auto place = fine.owned().index_within_set(indices[i]);
                  if (!is_done[place])
                    visit(cell, i, indices, vertices);
                  is_done[place] = true;
                }
          }
    }

    /// The vertices of a cell whose mean is the position of a node.
    template <int dim>
    std::vector<unsigned int>
    vertices_of_mean(const ReferenceCell &cell, const Point<dim> &node)
    {
      std::vector<unsigned int> result;
      for (const unsigned int v : cell.vertex_indices())
        if (cell.d_linear_shape_function(node, v) > 1e-10)
          result.push_back(v);
      return result;
    }

    /// The prolongation in space without a matrix: each node of degree two is the mean of 1, 2, 4
    /// or 8 vertices.
    std::unique_ptr<const Prolongation>
    means_of_vertices(const Elasticity<3> &fine, const LinearSpace<3> &space)
    {
      constexpr unsigned int dim = 3;
      // The vertices of each node depend on the element only, and are found once.
      std::vector<std::vector<std::vector<unsigned int>>> vertices_of; // [element][node]
      for (unsigned int e = 0; e < fine.finite_elements().size(); ++e)
        {
          vertices_of.emplace_back();
          const FiniteElement<dim> &scalar = fine.finite_elements()[e].base_element(0);
          for (const Point<dim> &node : scalar.get_unit_support_points())
            vertices_of.back().push_back(vertices_of_mean(scalar.reference_cell(), node));
        }
      InterpolationTransfer::Nodes nodes;
      visit_nodes(fine,
                  space,
                  [&](const auto &cell, const auto i, const auto &indices, const auto &vertices) {
                    const auto [component, node] = cell->get_fe().system_to_component_index(i);
                    // The three components of a node have the same interpolation; the first one
                    // stands for all.
                    if (component != 0)
                      return;
                    std::vector<types::global_dof_index> of;
                    for (const unsigned int v : vertices_of[cell->active_fe_index()][node])
                      of.push_back(vertices[v * dim]);
                    nodes.add(indices[i], of.data(), of.size());
                  });
      return std::make_unique<InterpolationTransfer>(
        std::move(nodes),
        InterpolationTransfer::Side{fine.owned(), fine.constraints()},
        InterpolationTransfer::Side{space.owned, space.constraints},
        space.owned.size() - space.dofs.n_dofs(),
        fine.mesh().communicator());
    }

    /// The prolongation as a matrix, for plane models: rows of constrained degrees of freedom are
    /// empty. Collective.
    template <int dim>
    std::unique_ptr<const Prolongation>
    assembled_prolongation(const Elasticity<dim> &fine, const LinearSpace<dim> &space)
    {
      const NodeRows<dim>                                  rows(space);
      std::vector<std::pair<types::global_dof_index, Row>> found;
      visit_nodes(fine,
                  space,
                  [&](const auto &cell, const auto i, const auto &indices, const auto &vertices) {
                    if (fine.constraints().is_constrained(indices[i]))
                      return;
                    found.emplace_back(indices[i], Row());
                    rows.add(cell->get_fe(), i, 1., vertices, found.back().second);
                  });
      for (auto i = fine.dof_handler().n_dofs(); i < fine.owned().size(); ++i)
        if (fine.owned().is_element(i) && !fine.constraints().is_constrained(i))
          found.emplace_back(i, Row{{i - fine.dof_handler().n_dofs() + space.dofs.n_dofs(), 1.}});

      // Rows of constrained degrees of freedom stay empty: a correction from the coarser level must
      // not move them.
      LA::SparsityPattern pattern(fine.owned(), space.owned, fine.mesh().communicator());
      for (const auto &[i, row] : found)
        for (const auto &entry : row)
          pattern.add(i, entry.first);
      pattern.compress();
      LA::SparseMatrix P;
      P.reinit(pattern);
      for (const auto &[i, row] : found)
        for (const auto &[j, value] : row)
          P.set(i, j, value);
      P.compress(VectorOperation::insert);
      return std::make_unique<AssembledProlongation>(std::move(P));
    }
  } // namespace



  // In space elements of degree 2 have nodes at means of vertices, and the prolongation needs no
  // matrix; otherwise it is assembled.
  template <int dim>
  std::unique_ptr<const Prolongation>
  make_prolongation(const Elasticity<dim> &fine, const LinearSpace<dim> &space)
  {
    if constexpr (dim == 3)
      // Nodes of higher degrees are not at means of vertices.
      if (fine.degree() <= 2)
        return means_of_vertices(fine, space);
    return assembled_prolongation(fine, space);
  }



  // Diagonal terms are restricted like forces, those of rigid bodies copied: these are the same
  // degrees of freedom on both levels. In single precision. Collective.
  LA::Vector
  restrict_terms(const LA::Vector   &terms,
                 const Prolongation &P,
                 const IndexSet     &owned,
                 const unsigned int  n_rigid)
  {
    LA::Vector               result(owned, terms.get_mpi_communicator());
    const double *const      above = LA::values_of(terms);
    const std::vector<float> single_precision(above, above + terms.locally_owned_size());
    // The transposed prolongation distributes a diagonal value to vertices with the weights of the
    // interpolation. It keeps the sum, and with it the stiffness against translations, where no
    // vertex is constrained.
    std::vector<float> below(owned.n_elements());
    P.Tvmult(below.data(), single_precision.data());
    std::copy(below.begin(), below.end(), LA::values_of(result));
    for (auto i = owned.size() - n_rigid; i < owned.size(); ++i)
      if (owned.is_element(i))
        result(i) = terms(terms.size() - owned.size() + i);
    result.compress(VectorOperation::insert);
    return result;
  }



  // For each supported node of the fine space: the row of its constraint in terms of vertices, u_i
  // - sum_j w_ij u_j = 0. It vanishes where the constraints of the vertices imply it; otherwise it
  // becomes a penalty with the diagonal stiffness of the node (doc/theory, 7.1).
  template <int dim>
  CoarseConstraintPenalty::CoarseConstraintPenalty(const Elasticity<dim>  &fine,
                                                   const LinearSpace<dim> &space,
                                                   const LA::Vector       &diagonal)
    : comm(fine.mesh().communicator())
  {
    const NodeRows<dim>              rows(space);
    const AffineConstraints<double> &constraints = fine.constraints();
    visit_nodes(
      fine, space, [&](const auto &cell, const auto i, const auto &indices, const auto &vertices) {
        const auto dof = indices[i];
        if (!constraints.is_constrained(dof) || fine.hanging_nodes().is_constrained(dof))
          return;
        Row row;
        rows.add(cell->get_fe(), i, 1., vertices, row);
        for (const auto &[other, weight] : *constraints.get_constraint_entries(dof))
          {
            const auto at = std::find(indices.begin(), indices.end(), other);
            // Constraint equations refer to other cells. Only those of vertices are on this level.
            if (at == indices.end())
              return;
            rows.add(cell->get_fe(), at - indices.begin(), -weight, vertices, row);
          }
        // Entries cancel where the space of degree one satisfies the constraint by itself, up to
        // the rounding of their weights.
        const auto is_nothing = [](const auto &entry) { return std::abs(entry.second) < 1e-10; };
        row.erase(std::remove_if(row.begin(), row.end(), is_nothing), row.end());
        if (!row.empty())
          penalties.push_back({diagonal(dof), row});
      });
  }



  bool
  CoarseConstraintPenalty::any() const
  {
    return Utilities::MPI::max(penalties.empty() ? 0 : 1, comm) == 1;
  }



  // Add the stiffness times the products of entries of each row. The caller compresses the matrix.
  void
  CoarseConstraintPenalty::add_to(LA::SparseMatrix &K) const
  {
    for (const Penalty &penalty : penalties)
      for (const auto &[i, x] : penalty.row)
        for (const auto &[j, y] : penalty.row)
          K.add(i, j, penalty.stiffness * x * y);
  }



  template class LinearSpace<2>;
  template std::unique_ptr<const Prolongation>
  make_prolongation(const Elasticity<2> &, const LinearSpace<2> &);
  template CoarseConstraintPenalty::CoarseConstraintPenalty(const Elasticity<2> &,
                                                            const LinearSpace<2> &,
                                                            const LA::Vector &);
  template class LinearSpace<3>;
  template std::unique_ptr<const Prolongation>
  make_prolongation(const Elasticity<3> &, const LinearSpace<3> &);
  template CoarseConstraintPenalty::CoarseConstraintPenalty(const Elasticity<3> &,
                                                            const LinearSpace<3> &,
                                                            const LA::Vector &);
} // namespace Signorini
