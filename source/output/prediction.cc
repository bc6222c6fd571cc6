// SPDX-License-Identifier: Apache-2.0
#include "matrix_free/make_stiffness.h"
#include "output/preflight.h"
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
    /// Measured costs for one dimension, degree and form of the stiffness (scripts/calibrate).
    /// Times are in units of the time of assembling one cell, for each cell.
    struct Calibration
    {
      /// What a first solution does once.
      double set_up;
      /// One iteration of the linear solver.
      double iteration;
      /// Number of iterations of all Newton steps of a first solution.
      double iterations;
      /// Memory [bytes] for each entry of the stiffness matrix, also if it is not assembled.
      double bytes_per_entry;
    };

    /// @return the measured costs.
    Calibration
    calibration(const unsigned int dim, const unsigned int degree, const StiffnessForm form)
    {
      if (dim == 2)
        return degree == 1 ? Calibration{56, 2.1, 70, 88} : Calibration{50, 3.8, 75, 38};
      if (form == StiffnessForm::matrix_free)
        return degree == 1 ? Calibration{18, 0.4, 26, 11} : Calibration{6, 0.1, 32, 4};
      return degree == 1 ? Calibration{32, 1.4, 32, 33} : Calibration{16, 0.85, 34, 31};
    }

    /// Measured costs for each contact point.
    struct PointCosts
    {
      double
        /// Time of all searches and what follows from them, in units of assembling one cell.
             assemblies;
      double bytes;
    };

    /// @return the measured costs of contact points.
    PointCosts
    point_costs(const unsigned int dim, const unsigned int degree, const bool uses_current_geometry)
    {
      if (dim == 2)
        return {30, 4000};
      const PointCosts costs = degree == 1 ? PointCosts{40, 5000} : PointCosts{2.5, 9000};
      return uses_current_geometry ? costs : PointCosts{costs.assemblies / 4, costs.bytes / 2};
    }

    /// @return the form of the stiffness on the mesh of a refinement cycle.
    template <int dim>
    StiffnessForm
    form_of(const Scene<dim> &scene, const Elasticity<dim> &elasticity)
    {
      const bool needs_matrix = scene.solver.traits().needs_matrix;
      const auto wanted       = scene.solver.stiffness_form;
      return choose_form(wanted, needs_matrix, elasticity);
    }

    constexpr double base_memory_mb = 166; // of the libraries

    // The cost of a load step or refined mesh that starts from a solution, relative to a first
    // solution; the second number is the share of the set-up that each load step repeats.
    constexpr double warm_share = 0.6, set_up_of_steps = 0.2;

    /// The cells with one element, on all ranks.
    struct Cells
    {
      double n = 0;
      /// Time of assembling one cell [s].
      double seconds = 0;
    };

    /// @return the median, which is not influenced by the first cells and by other load of the
    /// machine; 0 without samples.
    double
    median(std::vector<double> &samples)
    {
      if (samples.empty())
        return 0;
      const auto middle = samples.begin() + samples.size() / 2;
      std::nth_element(samples.begin(), middle, samples.end());
      return *middle;
    }

    /// @return number and assembly time of the cells of all ranks, by the index of their element.
    /// Plain elasticity is measured for all models, since the expensive parts do not depend on the
    /// model. Collective.
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
            // Measure the assembly of single cells, until there are enough samples.
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



  // The sum over refinement cycles and load steps of: work before the solution and at contact
  // points, which scales with the surface, and set-up and iterations, which scale with the number
  // of cells.
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

    // Contact points cost as much as those of the most expensive cells.
    const PointCosts of_points     = point_costs(dim, elasticity.degree(), uses_current_geometry);
    double           point_seconds = 0;
    for (const Cells &cells : counted)
      point_seconds = std::max(point_seconds, of_points.assemblies * cells.seconds);

    Prediction result;
    result.seconds_before = Utilities::MPI::max(seconds, elasticity.mesh().communicator());
    result.memory_mb      = base_memory_mb;
    const double most     = std::max(1., refinement.maximum_cells / all_cells);
    // Each unconstrained mode costs set-up time for its vectors.
    const double loose =
      1 + elasticity.unsupported_mode_names().size() / 12.; // vectors of all unknowns
    double size = 1;                                        // of this mesh, in that of the first
    for (unsigned int cycle = 0; cycle <= refinement.cycles; ++cycle)
      {
        // The load steps after the first one are computed on the last mesh only.
        const double starts  = cycle == 0 ? 1 : warm_share, // in cold ones
          steps              = cycle < refinement.cycles ? 0 : scene.load_steps.ends().size() - 1.;
        const double surface = std::pow(size, (dim - 1.) / dim);
        result.seconds += surface * (result.seconds_before +
                                     (starts + warm_share * steps) * points * point_seconds);
        for (unsigned int i = 0; i < elements.size(); ++i)
          {
            const auto   costs = calibration(dim, elements[i].degree, form_of(scene, elasticity));
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
        // Memory of the last mesh: rows of the stiffness matrix have dim (2 p + 1)^dim entries in
        // the interior for p = 1, and fewer in the mean for p = 2.
        const unsigned int degree        = elements[i].degree;
        const double       dofs_per_cell = dofs_per_node * std::pow(degree, dim),
                     entries_per_dof     = dim * std::pow(degree == 1 ? 3 : 4, dim);
        result.memory_mb += size * counted[i].n * dofs_per_cell / n_ranks * entries_per_dof *
                            calibration(dim, degree, form_of(scene, elasticity)).bytes_per_entry /
                            1e6;
        result.seconds_per_cell += counted[i].seconds * counted[i].n / all_cells;
      }
    result.memory_mb += std::pow(size, (dim - 1.) / dim) * points * of_points.bytes / 1e6;
    // Neither the size of load steps at finite strain nor their Newton iterations are known in
    // advance.
    if (elasticity.is_finite_strain())
      result.seconds = std::numeric_limits<double>::quiet_NaN();
    // The cost of a factorisation depends on the fill-in, and on how often the active set changes.
    if (!scene.solver.traits().uses_hierarchy)
      result.seconds = result.memory_mb = std::numeric_limits<double>::quiet_NaN();
    return result;
  }



  template Prediction
  predict(const Scene<2> &, const Elasticity<2> &, unsigned int, double);
  template Prediction
  predict(const Scene<3> &, const Elasticity<3> &, unsigned int, double);
} // namespace Signorini
