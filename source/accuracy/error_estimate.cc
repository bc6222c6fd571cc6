// SPDX-License-Identifier: Apache-2.0
#include "accuracy/error_estimate.h"

#include "accuracy/error_parts.h"

#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// @return the sum of zeta W g over active points, (8.10): the change of the quantity if the
    /// gaps that a penalty leaves were closed. With friction also the elastic slip, which is to the
    /// tangential traction as the gap is to the pressure. Collective.
    template <int dim>
    double
    of_open_gaps(const Snapshot<dim> &s, const PointVectors &zeta)
    {
      double sum = 0;
      for (const auto i : s.gap.locally_owned_elements())
        if (s.active(i) > 0)
          {
            const double gap =
              s.gap(i) + s.contact.coefficients.overclosure(i, s.pressure(i)).value;
            double change = zeta[0](i) * gap;
            for (unsigned int a = 1; a < zeta.size() && s.pressure(i) > 0; ++a)
              change += zeta[a](i) * s.contact_state.traction[a](i) * gap / s.pressure(i);
            sum += s.contact.weight(i) * change;
          }
      return Utilities::MPI::sum(sum, s.gap.get_mpi_communicator());
    }

    /// @return the first of (8.11): minus the sum of (B z) W p over points in tension that are not
    /// bilateral, i.e. the change of the quantity without their forces. Collective.
    template <int dim>
    double
    of_tension(const Snapshot<dim> &s, const LA::Vector &z)
    {
      LA::Vector opening = s.contact.zero();
      if (s.contact.empty())
        return 0;
      s.contact.B.vmult(opening, z);
      double sum = 0;
      for (const auto i : opening.locally_owned_elements())
        if (s.pressure(i) < 0 && s.contact.coefficients.least_status(i) == 0)
          sum -= opening(i) * s.contact.weight(i) * s.pressure(i);
      return Utilities::MPI::sum(sum, opening.get_mpi_communicator());
    }
  } // namespace



  // First all fields of all quantities together, since the recovery of stresses is the expensive
  // part; then the parts of each quantity.
  template <int dim>
  ErrorEstimate
  error_estimate(const Snapshot<dim>             &snapshot,
                 const std::vector<Functional>   &functionals,
                 const std::vector<DualSolution> &duals,
                 const bool                       is_consistent,
                 const std::vector<double>       &path,
                 const double                     neglected)
  {
    const MPI_Comm comm = snapshot.elasticity.mesh().communicator();
    // The lift of a quantity is subtracted from its dual displacement, see Functional.
    std::vector<DualField> fields;
    for (unsigned int i = 0; i < duals.size(); ++i)
      {
        fields.push_back({duals[i].z, duals[i].volumetric_stress});
        if (functionals[i].lift.size() > 0)
          fields.back().displacement -= functionals[i].lift;
      }
    ErrorEstimate result;
    result.cells  = cell_errors(snapshot.elasticity, snapshot.displacement, fields);
    double energy = 0;
    for (const double e : result.cells.energy)
      energy += e;
    energy        = Utilities::MPI::sum(energy, comm);
    result.energy = result.cells.energy_of_solution > 0 ?
                      std::sqrt(energy / result.cells.energy_of_solution) :
                      0.;
    // Errors of the boundaries exist only for quantities.
    const BoundaryErrors boundaries =
      duals.empty() ? BoundaryErrors() :
                      boundary_errors(snapshot.elasticity, snapshot.displacement, fields);
    const std::vector<std::vector<double>> of_loads = load_errors(snapshot.elasticity, fields);
    for (unsigned int i = 0; i < duals.size(); ++i)
      {
        const LA::Vector    &z   = fields[i].displacement;
        double               sum = 0, absolute = 0, geometry = 0, sizes = 0;
        std::vector<double> &of_cells     = result.cells.products[i];
        const auto           of_dirichlet = dirichlet_contact_errors(snapshot, functionals[i], z);
        const auto           of_points    = pointwise_contact_errors(snapshot, functionals[i], z);
        const auto           of_layers    = compliance_errors(snapshot, functionals[i], z);
        const auto           of_edges     = unresolved_contact(snapshot, functionals[i], z);
        for (unsigned int cell = 0; cell < of_cells.size(); ++cell)
          {
            // The sums that enter the bound (8.13) do not contain the parts of geometry, of the
            // edge of contact and of thin layers; the refinement indicators do, the latter two with
            // the sign of the rest, so that they never cancel.
            of_cells[cell] += boundaries.of_supports[i][cell] + of_loads[i][cell] +
                              of_dirichlet[cell] + of_points[cell] + of_layers[cell];
            sum += of_cells[cell];
            absolute += std::abs(of_cells[cell]);
            const double of_geometry =
              boundaries.of_geometry[i][cell] +
              (functionals[i].is_quadratic ? boundaries.of_energy[cell] : 0.);
            of_cells[cell] += of_geometry;
            geometry += of_geometry;
            const double size = of_edges[cell] + result.cells.layers[i][cell];
            of_cells[cell] += std::copysign(size, of_cells[cell]);
            sizes += size;
          }
        QuantityEstimate one;
        one.value          = functionals[i].value;
        one.is_regularised = functionals[i].is_regularised;
        one.is_singular    = functionals[i].is_singular;
        one.unresolved     = functionals[i].unresolved + Utilities::MPI::sum(sizes, comm) +
                         undetermined_contact(snapshot, functionals[i], z);
        one.cauchy_schwarz_bound = result.cells.cauchy_schwarz_bounds[i] +
                                   std::abs(functionals[i].local) +
                                   (functionals[i].is_quadratic ? energy / 2 : 0.);
        one.parts.discretisation = Utilities::MPI::sum(sum, comm) + functionals[i].local +
                                   (functionals[i].is_quadratic ? -energy / 2 : 0.);
        // What is recovered at a point is less certain than a sum over cells.
        one.absolute = Utilities::MPI::sum(absolute, comm) + 3 * std::abs(functionals[i].local) +
                       (functionals[i].is_quadratic ? energy / 2 : 0.);
        one.parts.geometry = Utilities::MPI::sum(geometry, comm);
        // Consistent methods close gaps with the mesh, so that the part of their gaps is none of
        // the enforcement. The gaps that Nitsche's method leaves are smaller on finer meshes.
        if (const bool is_of_mesh = snapshot.contact.has_stress(); !is_consistent || is_of_mesh)
          {
            const double of_gaps = of_open_gaps(snapshot, duals[i].zeta);
            (is_of_mesh ? one.parts.discretisation : one.parts.enforcement) += of_gaps;
            if (is_of_mesh)
              one.absolute += std::abs(of_gaps);
          }
        one.parts.nonlinear = of_tension(snapshot, z);
        one.parts.algebraic = duals[i].remainder;
        one.parts.model     = neglected * std::abs(one.value);
        one.parts.path      = path.empty() ? 0. : path[i];
        result.iterations += duals[i].iterations;
        result.quantities.push_back(one);
      }
    return result;
  }



  template ErrorEstimate
  error_estimate(const Snapshot<2> &,
                 const std::vector<Functional> &,
                 const std::vector<DualSolution> &,
                 bool,
                 const std::vector<double> &,
                 double);
  template ErrorEstimate
  error_estimate(const Snapshot<3> &,
                 const std::vector<Functional> &,
                 const std::vector<DualSolution> &,
                 bool,
                 const std::vector<double> &,
                 double);
} // namespace Signorini
