// SPDX-License-Identifier: Apache-2.0
#include "accuracy/refinement.h"

#include <signorini/parameters/section.h>

#include <deal.II/distributed/grid_refinement.h>
#include <deal.II/distributed/solution_transfer.h>
#include <deal.II/distributed/tria.h>

namespace Signorini
{
  using namespace dealii;

  void
  RefinementSettings::declare(Section &section)
  {
    section.add("Refinement cycles",
                cycles,
                "number of adaptive refinements of the mesh, each followed by a new solution");
    section.add_choice("Strategy",
                       strategy,
                       {{"estimator", Strategy::estimator}, {"global", Strategy::global}},
                       "estimator: where the error estimate is largest; global: everywhere");
    section.add("Refine fraction",
                refine_fraction,
                "fraction of the cells that are refined",
                Range{0, 1});
    section.add("Coarsen fraction",
                coarsen_fraction,
                "fraction of the cells that are coarsened",
                Range{0, 1});
    section.add("Maximum cells", maximum_cells, "no refinement beyond", positive);
    section.add(
      "Tolerance",
      tolerance,
      "of Newton's method on meshes that will be refined, if larger than Newton/Tolerance; with a "
      "Target error up to ten times larger if the algebraic error allows it",
      Range{0, 0.1});
    if (refine_fraction + coarsen_fraction > 1)
      section.fail("Refine fraction", "plus Coarsen fraction must not exceed 1");
  }



  template <int dim>
  void
  mark_cells(const RefinementSettings &settings, Mesh<dim> &mesh, const std::vector<double> &errors)
  {
    auto &triangulation =
      dynamic_cast<parallel::distributed::Triangulation<dim> &>(mesh.triangulation());
    if (settings.strategy == RefinementSettings::Strategy::global)
      triangulation.set_all_refine_flags();
    else
      parallel::distributed::GridRefinement::refine_and_coarsen_fixed_number(
        triangulation,
        Vector<double>(errors.begin(), errors.end()),
        settings.refine_fraction,
        settings.coarsen_fraction,
        settings.maximum_cells);
  }



  // Dörfler marking: the smallest set of cells that has the share.
  template <int dim>
  void
  mark_share(const RefinementSettings  &settings,
             Mesh<dim>                 &mesh,
             const std::vector<double> &indicators,
             const double               share)
  {
    // The share of the sum that coarsened cells may have together. It is small since a cell of
    // twice the size has up to 2^(2 degree + dim) times its error.
    constexpr double negligible = 2e-4;
    if (settings.strategy == RefinementSettings::Strategy::global)
      return mark_cells(settings, mesh, indicators);
    auto &triangulation =
      dynamic_cast<parallel::distributed::Triangulation<dim> &>(mesh.triangulation());
    parallel::distributed::GridRefinement::refine_and_coarsen_fixed_fraction(
      triangulation,
      Vector<double>(indicators.begin(), indicators.end()),
      share,
      negligible,
      VectorTools::NormType::L1_norm);
  }



  template <int dim>
  double
  growth(const Mesh<dim> &mesh)
  {
    constexpr double children = GeometryInfo<dim>::max_children_per_cell;
    double           change   = 0;
    for (const auto &cell : mesh.triangulation().active_cell_iterators())
      if (cell->is_locally_owned())
        change += cell->refine_flag_set()  ? children - 1 :
                  cell->coarsen_flag_set() ? 1 / children - 1 :
                                             0.;
    return 1 + Utilities::MPI::sum(change, mesh.communicator()) /
                 mesh.triangulation().n_global_active_cells();
  }



  template <int dim>
  void
  clear_marks(Mesh<dim> &mesh)
  {
    for (const auto &cell : mesh.triangulation().active_cell_iterators())
      {
        cell->clear_refine_flag();
        cell->clear_coarsen_flag();
      }
  }



  // The parts of vectors that belong to the mesh are interpolated by deal.II; those of rigid bodies
  // are carried over unchanged.
  template <int dim>
  void
  refine(Mesh<dim> &mesh, Elasticity<dim> &elasticity, const std::vector<LA::Vector *> &vectors)
  {
    auto &triangulation =
      dynamic_cast<parallel::distributed::Triangulation<dim> &>(mesh.triangulation());
    for (const auto &cell : triangulation.active_cell_iterators())
      if (static_cast<unsigned int>(cell->level()) <= mesh.least_level(mesh.body(cell)))
        cell->clear_coarsen_flag();

    // Coarsening must not go below the cells of the scene; vectors need ghost values before the
    // refinement.
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

    elasticity.setup(elasticity.time_of_supports());
    // After the refinement all vectors have new layouts.
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
  }



#define INSTANTIATE(dim)                                                                            \
  template void   mark_cells(const RefinementSettings &, Mesh<dim> &, const std::vector<double> &); \
  template void   mark_share(const RefinementSettings &,                                            \
                             Mesh<dim> &,                                                           \
                             const std::vector<double> &,                                           \
                             double);                                                               \
  template double growth(const Mesh<dim> &);                                                        \
  template void   clear_marks(Mesh<dim> &);                                                         \
  template void   refine(Mesh<dim> &, Elasticity<dim> &, const std::vector<LA::Vector *> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
