// SPDX-License-Identifier: Apache-2.0
#include "accuracy/quantities/kinds.h"
#include "solid/cell_displacement.h"
#include "solid/cell_nodes.h"
#include "solid/scalar_elements.h"
#include "solid/stress_state.h"
#include <signorini/solid/model.h>

namespace Signorini
{
  using namespace dealii;

  // The derivative of the energy is the vector of internal forces, the integral of P:Grad v; by the
  // volumetric stress it is zero. Its second derivative is that of the error, see error_estimate().
  template <int dim>
  Functional
  energy(const QuantityName &, const Snapshot<dim> &s, const Probes<dim> &)
  {
    const Elasticity<dim> &elasticity = s.elasticity;
    const LA::Vector       ghosted    = elasticity.with_ghosts(s.displacement);
    CellDisplacement<dim>  at(elasticity, ghosted, gauss_rules(elasticity.finite_elements(), 1));
    const FEValuesExtractors::Vector     displacement(0);
    std::vector<types::global_dof_index> indices;
    Vector<double>                       forces;
    Functional                           result = zero_functional(s);
    double                               sum    = 0;
    for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const FEValues<dim> &values = at.reinit(cell);
          read_indices<dim>(cell, indices);
          forces.reinit(indices.size());
          for (const unsigned int q : values.quadrature_point_indices())
            {
              const Point<dim> &x      = values.quadrature_point(q);
              const double      weight = values.JxW(q) * measure(elasticity.model(), x);
              const StressState state = stress_state(elasticity, *cell, at.gradient[q], at.u[q], x);
              sum += weight * state.energy;
              for (unsigned int i = 0; i < indices.size(); ++i)
                forces[i] +=
                  weight * scalar_product(state.stress,
                                          gradient_of_change(elasticity.model(),
                                                             values[displacement].gradient(i, q),
                                                             values[displacement].value(i, q),
                                                             x));
            }
          elasticity.constraints().distribute_local_to_global(forces,
                                                              indices,
                                                              result.of_displacement);
        }
    result.of_displacement.compress(VectorOperation::add);
    result.value        = Utilities::MPI::sum(sum, elasticity.mesh().communicator());
    result.is_quadratic = true;
    return result;
  }



  template Functional
  energy(const QuantityName &, const Snapshot<2> &, const Probes<2> &);
  template Functional
  energy(const QuantityName &, const Snapshot<3> &, const Probes<3> &);
} // namespace Signorini
