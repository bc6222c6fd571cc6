// SPDX-License-Identifier: Apache-2.0
// Quantities at points of bodies.
#include "accuracy/quantities/kinds.h"
#include "accuracy/quantities/singular_vertices.h"
#include "accuracy/recovered_field.h"
#include "fields/largest_stress.h"
#include "fields/point_state.h"
#include "fields/probe_cells.h"
#include "fields/probes.h"
#include "solid/stress.h"

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// @return the values at a probe of one point.
    template <int dim>
    ProbeValue<dim>
    value_at(const Snapshot<dim> &s, const Probe<dim> &probe)
    {
      return evaluate_probes(s.elasticity, s.displacement, std::vector<Probe<dim>>{probe})[0];
    }

    /// Set the error of a probe in a cell all of whose nodes are prescribed. Nothing in the scene
    /// changes the value there, so that the dual solution is zero and sees no error, but between
    /// the nodes the value is not known at all. Collective.
    /// @param size of the displacement or stress there
    void
    set_error_in_held_cell(const double           size,
                           const PointDerivative &derivative,
                           Functional            &functional)
    {
      if (derivative.of_displacement.linfty_norm() == 0)
        functional.unresolved = size;
    }

    /// @return the locally owned cell that a probe belongs to; none on other ranks. Collective.
    template <int dim>
    std::optional<typename DoFHandler<dim>::active_cell_iterator>
    own_cell(const Elasticity<dim> &elasticity, const Probe<dim> &probe)
    {
      const MPI_Comm comm      = elasticity.mesh().communicator();
      const auto     locations = own_locations<dim>(elasticity, {probe}, probe_tolerance);
      const auto     claims    = all_claims(locations, comm);
      if (rank_of_best_claim(claims, 0) == Utilities::MPI::this_mpi_process(comm))
        return locations[0].cell;
      return {};
    }

    /// Set the derivative of a functional to that of of_stress : sigma* at a point, with the
    /// recovered stress sigma* there, (8.5). The stress of the elements is of lower order, and as
    /// a functional of the displacement it is so rough that its dual solution is not resolved.
    /// Collective.
    /// @param cell that contains the point; none: on another rank
    /// @return sigma*
    template <int dim>
    SymmetricTensor<2, 3>
    set_recovered(const Snapshot<dim>                                                 &s,
                  const std::optional<typename DoFHandler<dim>::active_cell_iterator> &cell,
                  const Point<dim>                                                    &x,
                  const SymmetricTensor<2, 3>                                         &of_stress,
                  Functional                                                          &functional)
    {
      const Elasticity<dim> &elasticity = s.elasticity;
      SymmetricTensor<2, 3>  result;
      PointState<dim>        state(elasticity, s.displacement);
      PointDerivative        derivative(elasticity);
      // Samples may be in ghost cells; their derivatives are sent to the owners of the degrees of
      // freedom at the end.
      if (cell)
        for (const RecoverySample<dim> &sample : recovery_samples<dim>(elasticity, *cell, x))
          {
            state.evaluate(sample.cell, sample.unit, sample.place);
            result += sample.weight * state.stress();
            state.add_derivative(sample.weight, Tensor<1, dim>(), of_stress, derivative);
          }
      derivative.compress();
      functional.of_displacement      = std::move(derivative.of_displacement);
      functional.of_volumetric_stress = std::move(derivative.of_volumetric_stress);
      return Utilities::MPI::sum(result, elasticity.mesh().communicator());
    }

    /// @return what a displacement may miss between the nodes of its cell, as the singular dual
    /// solution of a point is not resolved there: the deviation of its gradient from the recovered
    /// one, integrated from the nearest node to the probe by Simpson's rule. Collective.
    template <int dim>
    Tensor<1, dim>
    missed_between_nodes(const Snapshot<dim> &s, const Probe<dim> &probe)
    {
      constexpr std::array<std::pair<double, double>, 3> rule{
        {{0., 1. / 6}, {0.5, 2. / 3}, {1., 1. / 6}}};
      const Elasticity<dim> &elasticity = s.elasticity;
      PointState<dim>        state(elasticity, s.displacement);
      Tensor<1, dim>         result;
      if (const auto cell = own_cell(elasticity, probe))
        {
          const Mapping<dim> &mapping = elasticity.mesh().mapping();
          const Point<dim>    unit    = mapping.transform_real_to_unit_cell(*cell, probe.point);
          Point<dim>          node    = (*cell)->reference_cell().template vertex<dim>(0);
          for (const Point<dim> &other : (*cell)->get_fe().get_unit_support_points())
            if (unit.distance(other) < unit.distance(node))
              node = other;
          const Point<dim>     start = mapping.transform_unit_to_real_cell(*cell, node);
          const Tensor<1, dim> way   = probe.point - start;
          for (const auto &[share, weight] : rule)
            {
              if (unit.distance(node) < 1e-8)
                break;
              const Point<dim> at = node + share * (unit - node),
                               x  = mapping.transform_unit_to_real_cell(*cell, at);
              state.evaluate(*cell, at, x);
              result -= weight * (state.gradient() * way);
              for (const RecoverySample<dim> &sample : recovery_samples<dim>(elasticity, *cell, x))
                {
                  state.evaluate(sample.cell, sample.unit, sample.place);
                  result += weight * sample.weight * (state.gradient() * way);
                }
            }
        }
      return Utilities::MPI::sum(result, elasticity.mesh().communicator());
    }

    /// @return the recovered Cauchy stress, (8.5).
    /// @param state of the solution, whose constructor is collective
    /// @param cell locally owned, with the point in it
    template <int dim>
    SymmetricTensor<2, 3>
    recovered_stress_in_cell(const Snapshot<dim>                                  &s,
                             PointState<dim>                                      &state,
                             const typename DoFHandler<dim>::active_cell_iterator &cell,
                             const Point<dim>                                     &x)
    {
      SymmetricTensor<2, 3> result;
      for (const RecoverySample<dim> &sample : recovery_samples<dim>(s.elasticity, cell, x))
        {
          state.evaluate(sample.cell, sample.unit, sample.place);
          result += sample.weight * state.stress();
        }
      return result;
    }

    /// @return the derivative of the von Mises stress by the stress, 3/2 dev(sigma)/sigma_v; zero
    /// stress has none.
    SymmetricTensor<2, 3>
    by_stress(const SymmetricTensor<2, 3> &stress)
    {
      const double size = von_mises(stress);
      return (size > 0 ? 1.5 / size : 0.) * deviator(stress);
    }
  } // namespace



  template <int dim>
  SymmetricTensor<2, 3>
  recovered_stress(const Snapshot<dim> &s, const Probe<dim> &probe)
  {
    SymmetricTensor<2, 3> result;
    PointState<dim>       state(s.elasticity, s.displacement);
    if (const auto cell = own_cell(s.elasticity, probe))
      result = recovered_stress_in_cell(s, state, *cell, probe.point);
    return Utilities::MPI::sum(result, s.elasticity.mesh().communicator());
  }



  template <int dim>
  Functional
  probe_displacement(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &probes)
  {
    const Probe<dim>    &probe  = probe_named(probes, name.of);
    const Tensor<1, dim> u      = value_at(s, probe).displacement,
                         missed = missed_between_nodes(s, probe);
    std::vector<Functional> components;
    for (unsigned int d = 0; d < dim; ++d)
      {
        Functional one                   = zero_functional(s);
        one.value                        = u[d];
        const PointDerivative derivative = probe_functional(
          s.elasticity, s.displacement, probe, Tensor<1, dim>(Point<dim>::unit_vector(d)), {});
        one.of_displacement = derivative.of_displacement;
        one.unresolved      = std::abs(missed[d]);
        set_error_in_held_cell(u.norm(), derivative, one);
        components.push_back(one);
      }
    return size_or_component(name, components);
  }



  namespace
  {
    /// @return a function of the stress at a probe, which is close to linear in its error.
    /// @param function of the stress
    /// @param of_stress its derivative
    template <int dim>
    Functional
    function_of_stress(const Snapshot<dim>                                        &s,
                       const Probe<dim>                                           &probe,
                       const std::function<double(const SymmetricTensor<2, 3> &)> &function,
                       const SymmetricTensor<2, 3>                                &of_stress,
                       const SymmetricTensor<2, 3>                                &stress)
    {
      Functional result = zero_functional(s);
      result.value      = function(stress);
      result.local =
        function(set_recovered(s, own_cell(s.elasticity, probe), probe.point, of_stress, result)) -
        result.value;
      set_error_in_held_cell(
        std::max(std::abs(result.value), stress.norm()),
        probe_functional(s.elasticity, s.displacement, probe, Tensor<1, dim>(), of_stress),
        result);
      if (const auto cell = own_cell(s.elasticity, probe))
        for (const Point<dim> &vertex : singular_vertices<dim>(s.elasticity, *cell))
          result.is_singular |= vertex.distance(probe.point) < 1e-9 * (*cell)->diameter();
      result.is_singular =
        Utilities::MPI::max(int(result.is_singular), s.elasticity.mesh().communicator()) == 1;
      return result;
    }
  } // namespace



  // The value is that of the elements, as in the results: a mean over the cells that share the
  // point. Its error is the difference to the recovered stress, and the error of that one.
  template <int dim>
  Functional
  probe_stress(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &probes)
  {
    const Probe<dim>  &probe = probe_named(probes, name.of);
    const unsigned int i     = component_number(name.component.substr(0, 1)),
                       j     = component_number(name.component.substr(1));
    SymmetricTensor<2, 3> which;
    // The product with a symmetric stress counts an off-diagonal component twice.
    which[i][j] = i == j ? 1 : 0.5;
    return function_of_stress<dim>(
      s,
      probe,
      [&](const SymmetricTensor<2, 3> &stress) { return stress[i][j]; },
      which,
      value_at(s, probe).stress);
  }



  template <int dim>
  Functional
  probe_von_mises(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &probes)
  {
    const Probe<dim>           &probe  = probe_named(probes, name.of);
    const SymmetricTensor<2, 3> stress = value_at(s, probe).stress;
    return function_of_stress<dim>(s, probe, von_mises, by_stress(stress), stress);
  }



  // The value is that of the superconvergent point where it is largest. The largest one of the
  // recovered stress, at that point or at a vertex of its cell, which may be on the surface, tells
  // the error.
  template <int dim>
  Functional
  largest_von_mises(const QuantityName &name, const Snapshot<dim> &s, const Probes<dim> &)
  {
    const Elasticity<dim> &elasticity = s.elasticity;
    const MPI_Comm         comm       = elasticity.mesh().communicator();
    const auto             stresses   = largest_stresses(elasticity, s.displacement);
    Functional             result     = zero_functional(s);
    for (unsigned int body = 0; body < stresses.size(); ++body)
      if (elasticity.mesh().body_name(body) == name.of)
        {
          Probe<dim> at;
          at.body      = name.of;
          at.point     = stresses[body].von_mises.position;
          result.value = stresses[body].von_mises.value;
          PointState<dim>         state(elasticity, s.displacement);
          const auto              cell = own_cell(elasticity, at);
          std::vector<Point<dim>> places;
          if (cell)
            {
              result.is_singular = !singular_vertices<dim>(elasticity, *cell).empty();
              places             = {at.point};
              for (const unsigned int v : (*cell)->vertex_indices())
                places.push_back((*cell)->vertex(v));
            }
          double                largest = -std::numeric_limits<double>::max();
          Point<dim>            place;
          SymmetricTensor<2, 3> there;
          for (const Point<dim> &x : places)
            {
              const SymmetricTensor<2, 3> stress = recovered_stress_in_cell(s, state, *cell, x);
              if (von_mises(stress) > largest)
                {
                  largest = von_mises(stress);
                  place   = x;
                  there   = stress;
                }
            }
          // Ranks without the cell have zero.
          there              = Utilities::MPI::sum(there, comm);
          result.is_singular = Utilities::MPI::max(int(result.is_singular), comm) == 1;
          result.local =
            von_mises(set_recovered(s, cell, place, by_stress(there), result)) - result.value;
        }
    return result;
  }



  template SymmetricTensor<2, 3>
  recovered_stress(const Snapshot<2> &, const Probe<2> &);
  template SymmetricTensor<2, 3>
  recovered_stress(const Snapshot<3> &, const Probe<3> &);
#define INSTANTIATE(quantity)                                                                      \
  template Functional quantity(const QuantityName &, const Snapshot<2> &, const Probes<2> &);      \
  template Functional quantity(const QuantityName &, const Snapshot<3> &, const Probes<3> &);
  INSTANTIATE(probe_displacement)
  INSTANTIATE(probe_stress)
  INSTANTIATE(probe_von_mises)
  INSTANTIATE(largest_von_mises)
#undef INSTANTIATE
} // namespace Signorini
