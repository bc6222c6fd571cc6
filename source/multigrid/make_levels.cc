// SPDX-License-Identifier: Apache-2.0
#include "linear_algebra/diagonal.h"
#include "matrix_free/cell_operator.h"
#include "multigrid/levels.h"
#include "multigrid/linear_space.h"
#include "solid/rigid_body_modes.h"

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The rigid-body modes on the space of degree one.
    template <int dim>
    std::vector<std::vector<double>>
    modes_of(const Elasticity<dim> &elasticity, const LinearSpace<dim> &space)
    {
      return rigid_body_modes(elasticity.mesh(), space.dofs, space.elements, space.owned);
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
              modes_of(elasticity, space),
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

    /// Coarser meshes below a space of degree one; none in the plane.
    template <int dim>
    Spaces
    coarser_meshes(const Elasticity<dim> &elasticity, const CellTangents *tangents)
    {
      if constexpr (dim == 3)
        return mesh_levels({elasticity.dof_handler(),
                            elasticity.hanging_nodes(),
                            elasticity.constraints(),
                            elasticity.owned(),
                            elasticity.diagonal_terms(),
                            rigid_body_modes(elasticity),
                            tangents},
                           elasticity);
      return {};
    }

    /// Coarser meshes below a space of degree one, which is itself a level below bodies of higher
    /// degree and then has products only.
    /// @param P prolongation from the space of degree one, moved into the result if there are
    /// coarser meshes
    template <int dim>
    Spaces
    coarser_meshes(const Elasticity<dim>               &elasticity,
                   const LinearSpace<dim>              &space,
                   const CellTangents                  *tangents,
                   std::unique_ptr<const Prolongation> &P,
                   const LA::Vector                    &terms)
    {
      Spaces result;
      if constexpr (dim == 3)
        {
          // Coarser meshes are built first: if there are none, the space of degree one must not be
          // given products only, since the hierarchy continues with aggregates, which need its
          // matrix. P remains with the caller in that case.
          const LinearDisplacements linear = displacements_of(elasticity, space, tangents, terms);
          result                           = mesh_levels(linear, elasticity);
          if (!result.levels.empty())
            result.levels.emplace(result.levels.begin(),
                                  std::move(P),
                                  std::make_unique<CellOperator<float>>(
                                    finest_space(linear, elasticity)));
        }
      return result;
    }
  } // namespace



  template <int dim>
  Spaces
  make_spaces(const Elasticity<dim> &elasticity,
              const Stiffness       &stiffness,
              const bool             to_coarser_meshes)
  {
    // Laws without tangents by cell have no geometric levels: their hierarchy consists of
    // aggregates.
    const CellTangents *const tangents = stiffness.tangents();
    if (elasticity.is_nonlinear() && !tangents)
      return {};
    if (elasticity.degree() == 1)
      return to_coarser_meshes ? coarser_meshes(elasticity, tangents) : Spaces();

    const LinearSpace<dim>        space(elasticity);
    auto                          P = make_prolongation(elasticity, space);
    const CoarseConstraintPenalty lost(elasticity, space, stiffness.diagonal());
    const LA::Vector              terms = restrict_terms(elasticity.diagonal_terms(),
                                            *P,
                                            space.owned,
                                            space.owned.size() - space.dofs.n_dofs());
    // The penalty for lost constraints has no matrix-free form: with it the space of degree one is
    // assembled, and aggregates follow.
    if (to_coarser_meshes && !lost.any())
      if (Spaces result = coarser_meshes(elasticity, space, tangents, P, terms);
          !result.levels.empty())
        return result;

    // No coarser meshes: the space of degree one is the last geometric level and needs a matrix.
    Spaces result;
    result.levels.emplace_back(std::move(P), assembled(elasticity, space, tangents, lost, terms));
    result.modes = modes_of(elasticity, space);
    return result;
  }



  template Spaces
  make_spaces(const Elasticity<2> &, const Stiffness &, bool);
  template Spaces
  make_spaces(const Elasticity<3> &, const Stiffness &, bool);
} // namespace Signorini
