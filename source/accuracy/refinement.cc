#include <signorini/accuracy/refinement.h>
#include <signorini/parameters/section.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/distributed/grid_refinement.h>
#include <deal.II/distributed/solution_transfer.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/hp/q_collection.h>
#include <deal.II/numerics/error_estimator.h>

#include <cmath>

namespace Signorini
{
  using namespace dealii;

  void
  RefinementSettings::declare(Section &section)
  {
    section.add("Refinement cycles",
                cycles,
                "how often the mesh is refined and the scene solved again");
    section.add_choice("Strategy",
                       strategy,
                       {{"estimator", Strategy::estimator}, {"global", Strategy::global}},
                       "estimator: where stress jumps between cells; global: everywhere");
    section.add("Refine fraction",
                refine_fraction,
                "share of the cells that are refined",
                Range{0, 1});
    section.add("Coarsen fraction",
                coarsen_fraction,
                "share of the cells that are coarsened",
                Range{0, 1});
    section.add("Maximum cells", maximum_cells, "no refinement beyond", positive);
    section.add(
      "Tolerance",
      tolerance,
      "of Newton's method on meshes that are still to be refined, if it is larger than Newton/Tolerance",
      Range{0, 0.1});
    if (refine_fraction + coarsen_fraction > 1)
      section.fail("Refine fraction", "plus Coarsen fraction must not exceed 1");
  }



  namespace
  {
    template <int dim>
    Vector<float>
    estimate(const Elasticity<dim> &elasticity, const LA::Vector &displacement)
    {
      Vector<float>            error(elasticity.mesh().triangulation().n_active_cells());
      hp::QCollection<dim - 1> rules;
      for (const auto &fe : elasticity.finite_elements())
        rules.push_back(QGauss<dim - 1>(fe.degree + 1));
      KellyErrorEstimator<dim>::estimate(elasticity.mesh().mapping(),
                                         elasticity.dof_handler(),
                                         rules,
                                         {},
                                         elasticity.with_ghosts(displacement),
                                         error);
      for (const auto &cell : elasticity.mesh().triangulation().active_cell_iterators())
        if (cell->is_locally_owned())
          error[cell->active_cell_index()] *=
            std::sqrt(elasticity.material(cell->material_id()).youngs_modulus);
      return error;
    }
  } // namespace



  template <int dim>
  double
  refine(const RefinementSettings        &settings,
         Mesh<dim>                       &mesh,
         Elasticity<dim>                 &elasticity,
         const LA::Vector                &displacement,
         const std::vector<LA::Vector *> &vectors)
  {
    auto &triangulation =
      dynamic_cast<parallel::distributed::Triangulation<dim> &>(mesh.triangulation());
    const Vector<float> error = estimate(elasticity, displacement);
    if (settings.strategy == RefinementSettings::Strategy::global)
      triangulation.set_all_refine_flags();
    else
      parallel::distributed::GridRefinement::refine_and_coarsen_fixed_number(
        triangulation,
        error,
        settings.refine_fraction,
        settings.coarsen_fraction,
        settings.maximum_cells);

    for (const auto &cell : triangulation.active_cell_iterators())
      if (static_cast<unsigned int>(cell->level()) <= mesh.least_level(cell->material_id()))
        cell->clear_coarsen_flag();

    std::vector<LA::Vector>          ghosted;
    std::vector<std::vector<double>> rigid;
    std::vector<const LA::Vector *>  in;
    for (const LA::Vector *v : vectors)
      {
        ghosted.push_back(elasticity.with_ghosts(*v));
        rigid.push_back(elasticity.rigid_motion(*v));
      }
    for (const LA::Vector &v : ghosted)
      in.push_back(&v);
    parallel::distributed::SolutionTransfer<dim, LA::Vector> transfer(elasticity.dof_handler());
    triangulation.prepare_coarsening_and_refinement();
    transfer.prepare_for_coarsening_and_refinement(in);
    triangulation.execute_coarsening_and_refinement();

    elasticity.setup();
    std::vector<LA::Vector>   parts(vectors.size(), elasticity.zero_mesh_vector());
    std::vector<LA::Vector *> out;
    for (LA::Vector &part : parts)
      out.push_back(&part);
    transfer.interpolate(out);
    for (unsigned int i = 0; i < vectors.size(); ++i)
      {
        *vectors[i] = elasticity.zero_vector();
        elasticity.set_mesh_part(parts[i], *vectors[i]);
        elasticity.set_rigid_motion(rigid[i], *vectors[i]);
      }
    return std::sqrt(Utilities::MPI::sum(error.norm_sqr(), mesh.communicator()));
  }



  template double
  refine(const RefinementSettings &,
         Mesh<2> &,
         Elasticity<2> &,
         const LA::Vector &,
         const std::vector<LA::Vector *> &);
  template double
  refine(const RefinementSettings &,
         Mesh<3> &,
         Elasticity<3> &,
         const LA::Vector &,
         const std::vector<LA::Vector *> &);
} // namespace Signorini
