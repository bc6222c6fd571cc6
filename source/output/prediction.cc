#include <signorini/elasticity/kernel.h>
#include <signorini/output/prediction.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <chrono>
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

    /// Cells with one kind of element.
    struct Cells
    {
      double n       = 0;
      double seconds = 0; ///< of the assembly of one
    };

    /// Of all ranks, by their element's index.
    template <int dim>
    std::vector<Cells>
    count_cells(const Elasticity<dim> &elasticity)
    {
      constexpr unsigned int enough = 100;
      StiffnessKernel<dim>   kernel(elasticity.mesh().mapping(),
                                  elasticity.finite_elements(),
                                  elasticity.model());
      FullMatrix<double>     matrix;
      std::vector<Cells>     result(elasticity.finite_elements().size());
      for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
        if (cell->is_locally_owned())
          {
            Cells &like = result[cell->active_fe_index()];
            if (++like.n > enough)
              continue;
            const auto start = std::chrono::steady_clock::now();
            kernel.assemble(cell, elasticity.material(cell->material_id()), matrix);
            like.seconds +=
              std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
          }
      const MPI_Comm comm = elasticity.mesh().communicator();
      for (Cells &like : result)
        {
          like.seconds =
            Utilities::MPI::max(like.seconds / std::clamp<double>(like.n, 1, enough), comm);
          like.n = Utilities::MPI::sum(like.n, comm);
        }
      return result;
    }
  } // namespace



  template <int dim>
  Prediction
  predict(const Scene<dim> &scene, const Elasticity<dim> &elasticity)
  {
    const double n_ranks = Utilities::MPI::n_mpi_processes(elasticity.mesh().communicator());
    // Refinement of the given share of the cells, as often as it is to come.
    const auto  &refinement = scene.refinement;
    const double growth     = refinement.strategy == "global" ?
                                std::pow(2, dim) :
                                1 + refinement.refine_fraction * (std::pow(2, dim) - 1);
    const double all_cells  = elasticity.mesh().triangulation().n_global_active_cells();
    const auto  &elements   = elasticity.finite_elements();
    const auto   counted    = count_cells(elasticity);

    double nodes = 0; // about: cells share those of their faces
    for (unsigned int i = 0; i < elements.size(); ++i)
      nodes += counted[i].n * std::pow(elements[i].degree, dim);
    const double dofs_per_node = elasticity.dof_handler().n_dofs() / nodes;

    Prediction result;
    result.seconds   = base_seconds;
    result.memory_mb = base_memory_mb;
    for (unsigned int i = 0; i < elements.size(); ++i)
      {
        const unsigned int degree     = elements[i].degree;
        const auto         costs      = calibration(dim, degree);
        double             cells      = counted[i].n;
        const double       most       = std::max(1., refinement.maximum_cells / all_cells) * cells;
        double             iterations = costs.iterations;
        for (unsigned int cycle = 0; cycle <= refinement.cycles; ++cycle)
          {
            if (cycle > 0)
              cells = std::min(growth * cells, most);
            if (cycle == refinement.cycles)
              iterations += warm_share * costs.iterations * (scene.load_steps.ends().size() - 1);
            result.seconds +=
              counted[i].seconds * cells / n_ranks * (costs.set_up + costs.iteration * iterations);
            iterations = warm_share * costs.iterations;
          }
        const double dofs_per_cell   = dofs_per_node * std::pow(degree, dim);
        const double entries_per_dof = dim * std::pow(degree == 1 ? 3 : 4, dim);
        result.memory_mb +=
          cells * dofs_per_cell / n_ranks * entries_per_dof * costs.bytes_per_entry / 1e6;
        result.seconds_per_cell += counted[i].seconds * counted[i].n / all_cells;
      }
    return result;
  }



  template Prediction
  predict(const Scene<2> &, const Elasticity<2> &);
  template Prediction
  predict(const Scene<3> &, const Elasticity<3> &);
} // namespace Signorini
