#include <signorini/elasticity/kernel.h>
#include <signorini/output/prediction.h>

#include <deal.II/base/timer.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Of one dimension and degree, by scripts/calibrate.
    struct Calibration
    {
      double set_up;          ///< seconds of all that is done once a mesh, in those of assembly
      double iteration;       ///< of one iteration of the linear solver, likewise
      double iterations;      ///< of all Newton steps of a cold start together
      double bytes_per_entry; ///< of the stiffness matrix
    };

    Calibration
    calibration(const unsigned int dim, const unsigned int degree)
    {
      if (dim == 2)
        return degree == 1 ? Calibration{20, 0.4, 70, 88} : Calibration{14, 0.45, 130, 46};
      return degree == 1 ? Calibration{11, 0.17, 35, 52} : Calibration{6, 0.12, 60, 31};
    }

    // Of the libraries, and of starting them.
    constexpr double base_memory_mb = 160, base_seconds = 0.05;

    // Of a load step or a refined mesh that starts from a solution, beside a cold start.
    constexpr double warm_share = 0.6;

    template <int dim>
    double
    seconds_per_cell(const Elasticity<dim> &elasticity)
    {
      constexpr unsigned int enough = 100;
      const auto            &fe     = elasticity.finite_element();
      StiffnessKernel<dim>   kernel(elasticity.mesh().mapping(), fe, elasticity.model());
      FullMatrix<double>     matrix(fe.n_dofs_per_cell());
      Timer                  clock;
      unsigned int           n = 0;
      for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
        if (cell->is_locally_owned())
          {
            kernel.assemble(cell, elasticity.material(cell->material_id()), matrix);
            if (++n == enough)
              break;
          }
      return clock.wall_time() / std::max(1u, n);
    }
  } // namespace



  template <int dim>
  Prediction
  predict(const Scene<dim> &scene, const Elasticity<dim> &elasticity)
  {
    const MPI_Comm     comm    = elasticity.mesh().communicator();
    const unsigned int degree  = elasticity.degree();
    const double       n_ranks = Utilities::MPI::n_mpi_processes(comm);
    // Refinement of the given share of the cells, as often as it is to come.
    const auto  &refinement    = scene.refinement;
    const double growth        = refinement.strategy == "global" ?
                                   std::pow(2, dim) :
                                   1 + refinement.refine_fraction * (std::pow(2, dim) - 1);
    double       cells         = elasticity.mesh().triangulation().n_global_active_cells();
    const double dofs_per_cell = elasticity.dof_handler().n_dofs() / cells;
    const auto   costs         = calibration(dim, degree);

    Prediction result;
    result.seconds_per_cell = Utilities::MPI::max(seconds_per_cell(elasticity), comm);
    result.seconds          = base_seconds;
    double iterations       = costs.iterations;
    for (unsigned int cycle = 0; cycle <= refinement.cycles; ++cycle)
      {
        if (cycle > 0)
          cells = std::min(growth * cells, std::max(cells, 1. * refinement.maximum_cells));
        if (cycle == refinement.cycles)
          iterations += warm_share * costs.iterations * (scene.load_steps.ends().size() - 1);
        result.seconds +=
          result.seconds_per_cell * cells / n_ranks * (costs.set_up + costs.iteration * iterations);
        iterations = warm_share * costs.iterations;
      }
    const double entries_per_dof = dim * std::pow(degree == 1 ? 3 : 4, dim);
    result.memory_mb = base_memory_mb + cells * dofs_per_cell / n_ranks * entries_per_dof *
                                          costs.bytes_per_entry / 1e6;
    return result;
  }



  template Prediction
  predict(const Scene<2> &, const Elasticity<2> &);
  template Prediction
  predict(const Scene<3> &, const Elasticity<3> &);
} // namespace Signorini
