// SPDX-License-Identifier: Apache-2.0
#include "linear_algebra/diagonal.h"
#include "matrix_free/cell_operator.h"
#include "multigrid/auxiliary_grids.h"
#include "multigrid/levels.h"
#include "multigrid/linear_space.h"
#include "solid/node_positions.h"

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The nodes of the space of degree one.
    template <int dim>
    NodePositions
    nodes_of(const Elasticity<dim> &elasticity, const LinearSpace<dim> &space)
    {
      return node_positions(elasticity.mesh(), space.dofs, space.elements, space.owned);
    }

    /// The space of degree one as the finest mesh of the coarser levels.
    LinearDisplacements
    displacements_of(const Elasticity<3>  &elasticity,
                     const LinearSpace<3> &space,
                     const CellTangents   *tangents,
                     const LA::Vector     &terms)
    {
      return {space.dofs,
              space.hanging,
              space.constraints,
              space.owned,
              terms,
              nodes_of(elasticity, space),
              tangents};
    }

    /// The matrix of the space of degree one: from tangents where there are some, otherwise from
    /// the materials, with the penalty for lost constraints and the diagonal terms. Collective.
    template <int dim>
    LA::SparseMatrix
    assembled(const Elasticity<dim>         &elasticity,
              const LinearSpace<dim>        &space,
              const CellTangents            *tangents,
              const CoarseConstraintPenalty &lost,
              const LA::Vector              &terms)
    {
      LA::SparseMatrix K;
      if constexpr (dim == 3)
        // Tangents exist in space only, where matrix-free operators do. The assembly of
        // finest_space() includes the diagonal terms already.
        if (tangents)
          {
            assemble(finest_space(displacements_of(elasticity, space, tangents, terms), elasticity),
                     K);
            lost.add_to(K);
            K.compress(VectorOperation::add);
            return K;
          }
      StiffnessAssembly<dim>(elasticity.mesh(),
                             elasticity.all_materials(),
                             elasticity.model(),
                             space.dofs,
                             space.elements,
                             space.constraints,
                             space.owned,
                             space.relevant)
        .assemble(K);
      lost.add_to(K);
      LA::add_to_diagonal(K, terms);
      return K;
    }

    /// Coarser meshes below bodies of degree one, or else grids.
    template <int dim>
    Spaces
    coarser_meshes(const Elasticity<dim> &elasticity, const Stiffness &stiffness)
    {
      Spaces result;
      if constexpr (dim == 3)
        // Laws without tangents by cell have a matrix.
        if (!elasticity.is_nonlinear() || stiffness.tangents())
          {
            const LinearDisplacements linear{elasticity.dof_handler(),
                                             elasticity.hanging_nodes(),
                                             elasticity.constraints(),
                                             elasticity.owned(),
                                             elasticity.diagonal_terms(),
                                             node_positions(elasticity),
                                             stiffness.tangents()};
            result = mesh_levels(linear, elasticity);
            if (!result.levels.empty())
              return result;
            // Tetrahedra at small strain have a matrix, see choose_form().
            if (elasticity.is_nonlinear() || !elasticity.mesh().has_simplices())
              return auxiliary_grids(finest_space(linear, elasticity), linear.nodes);
          }
      return auxiliary_grids(stiffness.matrix(), node_positions(elasticity));
    }

    /// A space of degree one below bodies of higher degree, and coarser meshes or grids below it.
    /// Collective.
    /// @param P prolongation from the space of degree one
    Spaces
    linear_and_coarser(const Elasticity<3>                &elasticity,
                       const LinearSpace<3>               &space,
                       const CellTangents                 *tangents,
                       std::unique_ptr<const Prolongation> P,
                       const LA::Vector                   &terms)
    {
      // Coarser meshes are built first: only if there are none, grids follow the space of degree
      // one.
      const LinearDisplacements linear = displacements_of(elasticity, space, tangents, terms);
      const CellSpace           finest = finest_space(linear, elasticity);
      Spaces                    result = mesh_levels(linear, elasticity);
      if (result.levels.empty())
        append_last(result, std::move(P), finest, linear.nodes);
      else
        result.levels.emplace(result.levels.begin(),
                              std::move(P),
                              std::make_unique<CellOperator<float>>(finest));
      return result;
    }
  } // namespace



  template <int dim>
  Spaces
  make_spaces(const Elasticity<dim> &elasticity,
              const Stiffness       &stiffness,
              const bool             to_coarser_meshes)
  {
    const CellTangents *const tangents = stiffness.tangents();
    if (elasticity.degree() == 1)
      return to_coarser_meshes ? coarser_meshes(elasticity, stiffness) : Spaces();
    // Laws without tangents by cell have no levels of lower degree: their hierarchy consists of
    // aggregates.
    if (elasticity.is_nonlinear() && !tangents)
      return {};

    const LinearSpace<dim>        space(elasticity);
    auto                          P = make_prolongation(elasticity, space);
    const CoarseConstraintPenalty lost(elasticity, space, stiffness.diagonal());
    const LA::Vector              terms = restrict_terms(elasticity.diagonal_terms(),
                                            *P,
                                            space.owned,
                                            space.owned.size() - space.dofs.n_dofs());
    // The penalty for lost constraints has no matrix-free form: with it the space of degree one is
    // assembled.
    if constexpr (dim == 3)
      if (to_coarser_meshes && !lost.any())
        return linear_and_coarser(elasticity, space, tangents, std::move(P), terms);

    Spaces           result;
    LA::SparseMatrix K = assembled(elasticity, space, tangents, lost, terms);
    if (to_coarser_meshes)
      append_last(result, std::move(P), std::move(K), nodes_of(elasticity, space));
    else
      {
        result.levels.emplace_back(std::move(P), std::move(K));
        result.nodes = nodes_of(elasticity, space);
      }
    return result;
  }



  template Spaces
  make_spaces(const Elasticity<2> &, const Stiffness &, bool);
  template Spaces
  make_spaces(const Elasticity<3> &, const Stiffness &, bool);
} // namespace Signorini
