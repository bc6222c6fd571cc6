// SPDX-License-Identifier: Apache-2.0
#include "solid/reactions.h"

#include "solid/cell_forces.h"
#include "solid/cell_nodes.h"
#include "solid/kernel.h"
#include "solid/pressure_kernel.h"

#include <algorithm>
#include <array>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Sums of the forces and moments of loads and supports, by support and by body.
    template <int dim>
    class Sums
    {
    public:
      Sums(const Elasticity<dim> &elasticity, const LA::Vector &u)
        : elasticity(elasticity)
        , displacement(elasticity.with_ghosts(u))
        , axisymmetric(elasticity.model() == Model::axisymmetric)
        , nodes_of(elasticity.mesh(), elasticity.finite_elements())
      {
        result.supports.resize(elasticity.supports().size());
        result.bodies.resize(elasticity.mesh().n_bodies());
      }

      /// Sum up the loads, and return the residual, internal forces minus loads, assembled over the
      /// cells that have loads or constrained degrees of freedom, hanging nodes condensed. At
      /// constrained degrees of freedom it is complete. Collective.
      LA::Vector
      add_loads();

      /// Sum up the forces of the supports: the residual at constrained nodes of this rank, by
      /// direction.
      void
      add_supports(const LA::Vector &residual);

      Reactions<dim>
      reduce_over_ranks();

    private:
      using Cell = typename DoFHandler<dim>::active_cell_iterator;

      /// The position of a node for moments: x at small strain, the displaced one at finite strain.
      /// @param indices degrees of freedom of the node
      template <typename Indices>
      Point<dim>
      place(const Point<dim> &x, const Indices &indices) const;
      void
      add_load(const Cell                                 &cell,
               const std::vector<types::global_dof_index> &indices,
               const Vector<double>                       &cell_load);
      void
      add_support(const ConstrainedNode<dim> &node, const Tensor<1, dim> &force);
      void
      sum_over_ranks(Resultant<dim> &resultant) const;

      const Elasticity<dim> &elasticity;
      const LA::Vector       displacement; ///< with ghosts
      const bool             axisymmetric;
      CellNodes<dim>         nodes_of;
      Reactions<dim>         result;
    };



    // In the displaced position nodes have other lever arms; at small strain the difference is
    // neglected.
    template <int dim>
    template <typename Indices>
    Point<dim>
    Sums<dim>::place(const Point<dim> &x, const Indices &indices) const
    {
      Point<dim> result = x;
      if (elasticity.is_finite_strain())
        for (unsigned int d = 0; d < dim; ++d)
          result[d] += displacement(indices[d]);
      return result;
    }



    // Add the nodal forces of the loads of a cell to the resultants of all loads and of its body.
    template <int dim>
    void
    Sums<dim>::add_load(const Cell                                 &cell,
                        const std::vector<types::global_dof_index> &indices,
                        const Vector<double>                       &cell_load)
    {
      const FiniteElement<dim>      &fe    = cell->get_fe();
      const std::vector<Point<dim>> &nodes = nodes_of(cell);
      for (unsigned int i = 0; i < nodes.size(); ++i)
        {
          // Each degree of freedom is the force of one component; the moment needs the position of
          // the node, and at finite strain all components of its displacement.
          const auto [component, node] = fe.system_to_component_index(i);
          // The radial forces of axisymmetric loads are in equilibrium around the circumference.
          if (axisymmetric && component == 0)
            continue;
          Tensor<1, dim> force;
          force[component] = cell_load[i];
          std::array<types::global_dof_index, dim> of_node;
          for (unsigned int d = 0; d < dim; ++d)
            of_node[d] = indices[fe.component_to_system_index(d, node)];
          const auto at_node = resultant_of(place(nodes[i], of_node), force);
          result.load += at_node;
          result.bodies[elasticity.mesh().body(cell)] += at_node;
        }
    }



    // The loop is over all cells of this rank. Element residuals are evaluated only where there are
    // loads or supports, since internal forces of other cells are not part of any resultant.
    template <int dim>
    LA::Vector
    Sums<dim>::add_loads()
    {
      LA::Vector                   residual = elasticity.zero_vector();
      CellForces<dim>              forces(elasticity);
      const std::vector<Load<dim>> dead = dead_loads(elasticity);
      LoadKernel<dim>              load_kernel(elasticity.mesh(),
                                  elasticity.finite_elements(),
                                  elasticity.model(),
                                  dead,
                                  elasticity.time());
      PressureKernel<dim>          pressures(elasticity);

      Vector<double>                       cell_load, values, of_pressure;
      std::vector<types::global_dof_index> indices;
      for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
        if (cell->is_locally_owned())
          {
            read_indices<dim>(cell, indices);
            bool loaded = load_kernel.assemble(cell, cell_load);
            if (!pressures.empty())
              {
                values.reinit(indices.size());
                cell->get_dof_values(displacement, values);
                if (pressures.assemble(cell, values, of_pressure))
                  {
                    cell_load += of_pressure;
                    loaded = true;
                  }
              }
            const bool supported = std::any_of(indices.begin(), indices.end(), [&](const auto i) {
              return elasticity.constraints().is_constrained(i) ||
                     elasticity.nodes_of_equations().count(i) > 0;
            });
            if (loaded)
              add_load(cell, indices, cell_load);
            if (loaded || supported)
              elasticity.hanging_nodes().distribute_local_to_global(
                forces.residual(cell, displacement, cell_load), indices, residual);
          }
      residual.compress(VectorOperation::add);
      return residual;
    }



    // Where several supports constrain a node, directions are orthonormalised in the order of the
    // supports, and each support has the force along its own part.
    template <int dim>
    void
    Sums<dim>::add_support(const ConstrainedNode<dim> &node, const Tensor<1, dim> &force)
    {
      const auto directions = node.orthonormal();
      for (unsigned int k = 0; k < directions.size(); ++k)
        // The axis of symmetry is a constraint without support; its radial force is in balance
        // around the circumference.
        if (const Support<dim> *support = node.prescribed_directions[k].support)
          {
            Tensor<1, dim> share = (force * directions[k]) * directions[k];
            if (axisymmetric)
              share[0] = 0;
            const auto at_node = resultant_of(place(node.position, node.dofs), share);
            result.supports[support - elasticity.supports().data()] += at_node;
            result.bodies[elasticity.mesh().pieces()[node.piece].body] += at_node;
          }
    }



    // A constrained node is visited by the rank that owns it only, so that no force counts twice.
    template <int dim>
    void
    Sums<dim>::add_supports(const LA::Vector &residual)
    {
      for (const auto &[index, node] : elasticity.constrained_nodes())
        if (elasticity.owned().is_element(index))
          {
            Tensor<1, dim> force;
            for (unsigned int d = 0; d < dim; ++d)
              force[d] = residual(node.dofs[d]);
            add_support(node, force);
          }
      // What is left at nodes of constraint equations are the forces of these.
      const auto &supported = elasticity.constrained_nodes();
      for (const auto &[index, node] : elasticity.nodes_of_equations())
        if (elasticity.owned().is_element(index))
          {
            Tensor<1, dim> force;
            for (unsigned int d = axisymmetric ? 1 : 0; d < dim; ++d)
              force[d] = residual(node.dofs[d]);
            if (const auto of_support = supported.find(index); of_support != supported.end())
              force = of_support->second.free_part(force);
            result.bodies[elasticity.mesh().pieces()[node.piece].body] +=
              resultant_of(place(node.position, node.dofs), force);
          }
    }



    // Resultants are small: one reduction for the force and one for the moment of each. Collective.
    template <int dim>
    void
    Sums<dim>::sum_over_ranks(Resultant<dim> &resultant) const
    {
      const MPI_Comm communicator = elasticity.mesh().communicator();
      resultant.force             = Utilities::MPI::sum(resultant.force, communicator);
      resultant.moment            = Utilities::MPI::sum(resultant.moment, communicator);
      // Moments of axisymmetric loads vanish.
      if (axisymmetric)
        resultant.moment = 0;
    }



    template <int dim>
    Reactions<dim>
    Sums<dim>::reduce_over_ranks()
    {
      sum_over_ranks(result.load);
      for (auto *list : {&result.supports, &result.bodies})
        for (Resultant<dim> &resultant : *list)
          sum_over_ranks(resultant);
      return result;
    }
  } // namespace



  // Reaction = internal forces - loads - contact forces at the constrained nodes.
  template <int dim>
  Reactions<dim>
  reactions(const Elasticity<dim> &elasticity, const LA::Vector &u, const LA::Vector &contact_force)
  {
    Sums<dim> sums(elasticity, u);
    // The residual is used at constrained nodes only, where it is complete and is the force of the
    // supports.
    LA::Vector residual = sums.add_loads();
    residual -= contact_force;
    sums.add_supports(residual);
    return sums.reduce_over_ranks();
  }



  template Reactions<2>
  reactions(const Elasticity<2> &, const LA::Vector &, const LA::Vector &);
  template Reactions<3>
  reactions(const Elasticity<3> &, const LA::Vector &, const LA::Vector &);
} // namespace Signorini
