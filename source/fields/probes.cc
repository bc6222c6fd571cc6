// SPDX-License-Identifier: Apache-2.0
#include "fields/probes.h"

#include "fields/probe_cells.h"
#include "solid/stress.h"
#include <signorini/solid/model.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature.h>
#include <deal.II/fe/fe_values.h>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Compute displacement, stress and strain at a point as means over the cells that share it.
    template <int dim>
    void
    evaluate(const Elasticity<dim>                &elasticity,
             const LA::Vector                     &displacement,
             const std::vector<CellLocation<dim>> &locations,
             const Point<dim>                     &x,
             Tensor<1, dim>                       &u,
             SymmetricTensor<2, 3>                &stress,
             SymmetricTensor<2, 3>                &strain)
    {
      const double share = 1. / locations.size();
      for (const CellLocation<dim> &location : locations)
        {
          FEValues<dim> values(elasticity.mesh().mapping(),
                               location.cell->get_fe(),
                               Quadrature<dim>(location.unit),
                               update_values | update_gradients);
          values.reinit(location.cell);
          std::vector<Tensor<1, dim>> us(1);
          std::vector<Tensor<2, dim>> gradients(1);
          values[FEValuesExtractors::Vector(0)].get_function_values(displacement, us);
          values[FEValuesExtractors::Vector(0)].get_function_gradients(displacement, gradients);
          u += share * us[0];
          stress += share * elasticity.stress(*location.cell, gradients[0], us[0], x);
          strain += share * elasticity.strain(*location.cell, gradients[0], us[0], x);
        }
    }
  } // namespace



  // The rank with the preferred cell evaluates each probe; the sum over ranks distributes the
  // values.
  template <int dim>
  std::vector<ProbeValue<dim>>
  evaluate_probes(const Elasticity<dim>         &elasticity,
                  const LA::Vector              &displacement,
                  const std::vector<Probe<dim>> &probes)
  {
    const MPI_Comm                       comm    = elasticity.mesh().communicator();
    const LA::Vector                     ghosted = elasticity.with_ghosts(displacement);
    const std::vector<CellLocation<dim>> locations =
      own_locations(elasticity, probes, probe_tolerance);
    // Each rank proposes its closest cell for each probe. All ranks know all proposals, and so the
    // same rank, without further communication.
    const auto claims = all_claims(locations, comm);

    std::vector<ProbeValue<dim>> result(probes.size());
    for (unsigned int i = 0; i < probes.size(); ++i)
      {
        const unsigned int rank  = rank_of_best_claim(claims, i);
        const Claim<dim>  &claim = claims[rank][i];
        if (claim.distance > probe_tolerance)
          throw_outside_of_bodies(probes[i], elasticity.mesh());

        Tensor<1, dim>        u;
        SymmetricTensor<2, 3> stress, strain;
        if (rank == Utilities::MPI::this_mpi_process(comm))
          evaluate(elasticity,
                   ghosted,
                   cells_about(elasticity.mesh().mapping(), locations[i], probes[i].point),
                   probes[i].point,
                   u,
                   stress,
                   strain);
        result[i].name         = probes[i].name;
        result[i].found        = true;
        result[i].displacement = Utilities::MPI::sum(u, comm);
        result[i].stress       = Utilities::MPI::sum(stress, comm);
        result[i].strain       = Utilities::MPI::sum(strain, comm);
        result[i].von_mises    = von_mises(result[i].stress);
      }
    return result;
  }



  // The transpose of the derivative of evaluate_probes() for one probe: the values and changes of
  // stress of all shape functions of the cells that share the point.
  template <int dim>
  PointDerivative
  probe_functional(const Elasticity<dim>       &elasticity,
                   const LA::Vector            &displacement,
                   const Probe<dim>            &probe,
                   const Tensor<1, dim>        &of_displacement,
                   const SymmetricTensor<2, 3> &of_stress)
  {
    const MPI_Comm  comm      = elasticity.mesh().communicator();
    const auto      locations = own_locations<dim>(elasticity, {probe}, probe_tolerance);
    const auto      claims    = all_claims(locations, comm);
    PointState<dim> state(elasticity, displacement);
    PointDerivative result(elasticity);
    if (rank_of_best_claim(claims, 0) == Utilities::MPI::this_mpi_process(comm))
      {
        // Values are means over the cells that share the point, so that each cell has the
        // weight one over their number.
        const auto cells = cells_about(elasticity.mesh().mapping(), locations[0], probe.point);
        for (const CellLocation<dim> &location : cells)
          {
            state.evaluate(location.cell, location.unit, probe.point);
            state.add_derivative(1. / cells.size(), of_displacement, of_stress, result);
          }
      }
    result.compress();
    return result;
  }



  template PointDerivative
  probe_functional(const Elasticity<2> &,
                   const LA::Vector &,
                   const Probe<2> &,
                   const Tensor<1, 2> &,
                   const SymmetricTensor<2, 3> &);
  template PointDerivative
  probe_functional(const Elasticity<3> &,
                   const LA::Vector &,
                   const Probe<3> &,
                   const Tensor<1, 3> &,
                   const SymmetricTensor<2, 3> &);
  template std::vector<ProbeValue<2>>
  evaluate_probes(const Elasticity<2> &, const LA::Vector &, const std::vector<Probe<2>> &);
  template std::vector<ProbeValue<3>>
  evaluate_probes(const Elasticity<3> &, const LA::Vector &, const std::vector<Probe<3>> &);
} // namespace Signorini
