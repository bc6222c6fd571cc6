// SPDX-License-Identifier: Apache-2.0
#include "fields/largest_stress.h"

#include "solid/cell_displacement.h"
#include "solid/scalar_elements.h"
#include "solid/stress.h"

#include <limits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Replace the value if another one is larger.
    template <int dim>
    void
    update_largest(ValueAtPosition<dim> &largest, const double value, const Point<dim> &x)
    {
      if (value > largest.value)
        largest = {value, x};
    }

    /// Replace the value by the largest one of all ranks, with its position; of equal ones that of
    /// the lowest rank. Collective.
    template <int dim>
    void
    reduce_over_ranks(ValueAtPosition<dim> &one, const MPI_Comm comm)
    {
      const double       largest = Utilities::MPI::max(one.value, comm);
      const unsigned int me      = Utilities::MPI::this_mpi_process(comm);
      const unsigned int owner =
        Utilities::MPI::min(one.value == largest ? me : numbers::invalid_unsigned_int, comm);
      one.value    = largest;
      one.position = Utilities::MPI::broadcast(comm, one.position, owner);
    }
  } // namespace



  // The rule with `degree` Gauss points in each direction has the superconvergent points.
  template <int dim>
  std::vector<LargestStresses<dim>>
  largest_stresses(const Elasticity<dim> &elasticity, const LA::Vector &displacement)
  {
    const Mesh<dim>      &mesh    = elasticity.mesh();
    const LA::Vector      ghosted = elasticity.with_ghosts(displacement);
    CellDisplacement<dim> at(elasticity, ghosted, gauss_rules(elasticity.finite_elements(), 0));
    LargestStresses<dim>  least;
    for (auto *one : {&least.von_mises, &least.shear, &least.principal})
      one->value = -std::numeric_limits<double>::max();
    std::vector<LargestStresses<dim>> result(mesh.n_bodies(), least);
    for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const FEValues<dim> &values = at.reinit(cell);
          // Stresses of each point are compared with the largest ones of its body.
          LargestStresses<dim> &largest = result[mesh.body(cell)];
          for (const unsigned int q : values.quadrature_point_indices())
            {
              const Point<dim> &x         = values.quadrature_point(q);
              const auto        sigma     = elasticity.stress(*cell, at.gradient[q], at.u[q], x);
              const auto        principal = eigenvalues(sigma); // the largest first
              update_largest(largest.von_mises, von_mises(sigma), x);
              update_largest(largest.shear, (principal[0] - principal[2]) / 2, x);
              update_largest(largest.principal, principal[0], x);
            }
        }
    for (LargestStresses<dim> &largest : result)
      for (auto *one : {&largest.von_mises, &largest.shear, &largest.principal})
        reduce_over_ranks(*one, mesh.communicator());
    return result;
  }



  template std::vector<LargestStresses<2>>
  largest_stresses(const Elasticity<2> &, const LA::Vector &);
  template std::vector<LargestStresses<3>>
  largest_stresses(const Elasticity<3> &, const LA::Vector &);
} // namespace Signorini
