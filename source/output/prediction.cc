// SPDX-License-Identifier: Apache-2.0
#include "output/prediction.h"

#include "matrix_free/make_stiffness.h"
#include "solid/kernel.h"

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Of one dimension, degree and form of the stiffness, by scripts/calibrate.
    struct Calibration
    {
      double set_up;          ///< seconds of what a cold start does once, in those of assembly
      double iteration;       ///< of one iteration of the linear solver, likewise
      double iterations;      ///< of all Newton steps of a cold start together
      double bytes_per_entry; ///< of the stiffness matrix, or of the one that there would be
    };

    Calibration
    calibration(const unsigned int dim, const unsigned int degree, const StiffnessForm form)
    {
      if (dim == 2)
        return degree == 1 ? Calibration{56, 2.1, 70, 88} : Calibration{50, 3.8, 75, 38};
      if (form == StiffnessForm::matrix_free)
        return degree == 1 ? Calibration{18, 0.4, 26, 11} : Calibration{6, 0.1, 32, 4};
      return degree == 1 ? Calibration{32, 1.4, 32, 33} : Calibration{16, 0.85, 34, 31};
    }

    /// Of a contact point, by the same.
    struct PointCosts
    {
      double
        assemblies; ///< seconds of all searches and what follows, in those of assembling a cell
      double bytes;
    };

    PointCosts
    point_costs(const unsigned int dim, const unsigned int degree, const bool uses_current_geometry)
    {
      if (dim == 2)
        return {30, 4000};
      const PointCosts costs = degree == 1 ? PointCosts{40, 5000} : PointCosts{2.5, 9000};
      return uses_current_geometry ? costs : PointCosts{costs.assemblies / 4, costs.bytes / 2};
    }

    /// After the refinements to come, too.
    template <int dim>
    StiffnessForm
    form_of(const Scene<dim> &scene, const Elasticity<dim> &elasticity, const unsigned int cycle)
    {
      const bool needs_matrix = scene.solver.needs_matrix();
      const auto wanted       = scene.solver.stiffness_form;
      return choose_form(wanted, needs_matrix, elasticity, cycle > 0);
    }

    constexpr double base_memory_mb = 166; // of the libraries

    // Of a load step or a refined mesh that starts from a solution, beside a cold start; of which
    // what is done once for all load steps is a part.
    constexpr double warm_share = 0.6, set_up_of_steps = 0.2;

    /// Cells with one kind of element.
    struct Cells
    {
      double n       = 0;
      double seconds = 0; ///< of the assembly of one
    };

    /// Which the first cells, and what else the machine does, do not disturb.
    double
    median(std::vector<double> &samples)
    {
      if (samples.empty())
        return 0;
      const auto middle = samples.begin() + samples.size() / 2;
      std::nth_element(samples.begin(), middle, samples.end());
      return *middle;
    }

    /// Of all ranks, by their element's index. The yardstick is plain elasticity, whatever the
    /// model is: what takes most does not depend on it.
    template <int dim>
    std::vector<Cells>
    count_cells(const Elasticity<dim> &elasticity)
    {
      constexpr std::size_t            enough = 300;
      StiffnessKernel<dim>             kernel(elasticity.mesh(),
                                  elasticity.finite_elements(),
                                  dim == 2 ? Model::plane_strain : Model::solid);
      FullMatrix<double>               matrix;
      std::vector<Cells>               result(elasticity.finite_elements().size());
      std::vector<std::vector<double>> samples(result.size());
      for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
        if (cell->is_locally_owned())
          {
            const unsigned int i = cell->active_fe_index();
            ++result[i].n;
            if (samples[i].size() == enough)
              continue;
            const auto start = std::chrono::steady_clock::now();
            kernel.assemble(cell, elasticity.material(cell->material_id()), matrix);
            samples[i].push_back(
              std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
          }
      const MPI_Comm comm = elasticity.mesh().communicator();
      for (unsigned int i = 0; i < result.size(); ++i)
        {
          result[i].seconds = Utilities::MPI::max(median(samples[i]), comm);
          result[i].n       = Utilities::MPI::sum(result[i].n, comm);
        }
      return result;
    }
  } // namespace



  template <int dim>
  Prediction
  predict(const Scene<dim>      &scene,
          const Elasticity<dim> &elasticity,
          const unsigned int     n_points,
          const double           seconds)
  {
    const MPI_Comm comm    = elasticity.mesh().communicator();
    const double   n_ranks = Utilities::MPI::n_mpi_processes(comm);
    const double   points  = Utilities::MPI::max(n_points, comm); // of one rank, whom others await
    const bool     uses_current_geometry = scene.contact.geometry != ContactGeometry::reference;
    // Refinement of the given share of the cells, as often as it is to come.
    const auto  &refinement = scene.refinement;
    const double growth     = refinement.strategy == RefinementSettings::Strategy::global ?
                                std::pow(2, dim) :
                                1 + refinement.refine_fraction * (std::pow(2, dim) - 1);
    const double all_cells  = elasticity.mesh().triangulation().n_global_active_cells();
    const auto  &elements   = elasticity.finite_elements();
    const auto   counted    = count_cells(elasticity);

    double nodes = 0; // about: cells share those of their faces
    for (unsigned int i = 0; i < elements.size(); ++i)
      nodes += counted[i].n * std::pow(elements[i].degree, dim);
    const double dofs_per_node = elasticity.dof_handler().n_dofs() / nodes;

    // Points cost what the dearest cells cost.
    const PointCosts of_points     = point_costs(dim, elasticity.degree(), uses_current_geometry);
    double           point_seconds = 0;
    for (const Cells &cells : counted)
      point_seconds = std::max(point_seconds, of_points.assemblies * cells.seconds);

    Prediction result;
    result.seconds_before = Utilities::MPI::max(seconds, elasticity.mesh().communicator());
    result.memory_mb      = base_memory_mb;
    const double most     = std::max(1., refinement.maximum_cells / all_cells);
    const double loose =
      1 + elasticity.unsupported_mode_names().size() / 12.; // vectors of all unknowns
    double size = 1;                                        // of this mesh, in that of the first
    for (unsigned int cycle = 0; cycle <= refinement.cycles; ++cycle)
      {
        const double starts  = cycle == 0 ? 1 : warm_share, // in cold ones
          steps              = cycle < refinement.cycles ? 0 : scene.load_steps.ends().size() - 1.;
        const double surface = std::pow(size, (dim - 1.) / dim);
        result.seconds += surface * (result.seconds_before +
                                     (starts + warm_share * steps) * points * point_seconds);
        for (unsigned int i = 0; i < elements.size(); ++i)
          {
            const auto costs =
              calibration(dim, elements[i].degree, form_of(scene, elasticity, cycle));
            const double n     = size * counted[i].n,
                         solve = costs.iteration * costs.iterations / n_ranks;
            result.seconds += counted[i].seconds * n *
                              (loose * costs.set_up / n_ranks * (1 + set_up_of_steps * steps) +
                               solve * (starts + warm_share * steps));
          }
        if (cycle < refinement.cycles)
          size = std::min(growth * size, most);
      }
    for (unsigned int i = 0; i < elements.size(); ++i)
      {
        const unsigned int degree        = elements[i].degree;
        const double       dofs_per_cell = dofs_per_node * std::pow(degree, dim),
                     entries_per_dof     = dim * std::pow(degree == 1 ? 3 : 4, dim);
        result.memory_mb +=
          size * counted[i].n * dofs_per_cell / n_ranks * entries_per_dof *
          calibration(dim, degree, form_of(scene, elasticity, refinement.cycles)).bytes_per_entry /
          1e6;
        result.seconds_per_cell += counted[i].seconds * counted[i].n / all_cells;
      }
    result.memory_mb += std::pow(size, (dim - 1.) / dim) * points * of_points.bytes / 1e6;
    // Nor is it known how large load steps of large deformation can be, and how many steps of
    // Newton's method they take.
    if (elasticity.is_finite_strain())
      result.seconds = std::numeric_limits<double>::quiet_NaN();
    // What a factorisation takes depends on the ordering that it finds, and on how often the active
    // set changes.
    if (scene.solver.preconditioner == "direct")
      result.seconds = result.memory_mb = std::numeric_limits<double>::quiet_NaN();
    return result;
  }



  template Prediction
  predict(const Scene<2> &, const Elasticity<2> &, unsigned int, double);
  template Prediction
  predict(const Scene<3> &, const Elasticity<3> &, unsigned int, double);
} // namespace Signorini
