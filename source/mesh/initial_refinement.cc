// SPDX-License-Identifier: Apache-2.0
#include "geometry/memory.h"
#include "mesh/mesh.h"
#include <signorini/parameters/raw.h>

#include <deal.II/distributed/tria.h>

#include <algorithm>
#include <cmath>
#include <sstream>

// Part of class Mesh: the refinement before the first solution.

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Throw SceneError if the refinement that is still to come will exceed the memory. Collective.
    /// @param n_refined lower bound of the number of refinements of cells of this rank
    /// Each refinement replaces a cell by its children, which adds one less than their number.
    /// Since the bound counts the refinements of the last pass only, no scene is rejected that
    /// would fit.
    template <int dim>
    void
    check_memory(const Triangulation<dim> &triangulation, const double n_refined)
    {
      const MPI_Comm     comm     = triangulation.get_communicator();
      const unsigned int children = GeometryInfo<dim>::max_children_per_cell;
      const double       n_cells  = triangulation.n_global_active_cells() +
                             Utilities::MPI::sum(n_refined, comm) * (children - 1);
      const double most = largest_number_of_cells() * Utilities::MPI::n_mpi_processes(comm);
      if (n_cells <= most)
        return;
      std::ostringstream text;
      text << "Mesh: the initial refinement would make " << n_cells << " cells, more than the "
           << most << " that fit into memory; set smaller Mesh/Refinements, Contact refinements, "
           << "Refinement regions/.../Levels or Bodies/.../Refinements, or coarser bodies";
      throw SceneError(text.str());
    }

    /// Throw SceneError if a cell would be finer than p4est allows. Collective.
    template <int dim>
    void
    check_levels(const Triangulation<dim> &triangulation, const int finest)
    {
      constexpr int most = dim == 2 ? 29 : 18; // P4EST_QMAXLEVEL, P8EST_QMAXLEVEL
      // Triangulations of other types than those of p4est have no such limit.
      const bool is_tree =
        dynamic_cast<const parallel::distributed::Triangulation<dim> *>(&triangulation) != nullptr;
      if (is_tree && Utilities::MPI::max(finest, triangulation.get_communicator()) > most)
        throw SceneError(
          "Mesh: the initial refinement would halve a cell more than " + std::to_string(most) +
          " times, the limit of p4est; set smaller Mesh/Refinements, "
          "Contact refinements, Refinement regions/.../Levels or Bodies/.../Refinements");
    }

    /// Refine certain cells repeatedly. Collective.
    /// @param times largest number of refinements
    /// @param growth factor, for a cell, by which the number of wanted cells grows at least with
    /// each refinement
    /// @param wanted function of a cell and the number of refinements that are left, including this
    /// one
    template <int dim, typename Growth, typename Wanted>
    void
    refine_where(Triangulation<dim> &triangulation,
                 const unsigned int  times,
                 const Growth       &growth,
                 const Wanted       &wanted)
    {
      for (unsigned int left = times; left > 0; --left)
        {
          std::size_t n_refined = 0;
          double      n_in_all  = 0;
          int         finest    = 0;
          for (const auto &cell : triangulation.active_cell_iterators())
            if (!cell->is_artificial() && wanted(cell, left))
              {
                cell->set_refine_flag();
                n_refined += cell->is_locally_owned();
                finest = std::max(finest, cell->level() + 1);
                // A cell that is refined now has at least growth^(left - 1) descendants that the
                // last pass refines. The check comes before the refinement, since a process that
                // runs out of memory could not print a message.
                n_in_all += cell->is_locally_owned() ? std::pow(growth(cell), left - 1) : 0.;
              }
          // The condition is collective, so that all ranks leave the loop in the same pass.
          if (Utilities::MPI::sum(n_refined, triangulation.get_communicator()) == 0)
            return;
          check_memory(triangulation, n_in_all);
          check_levels(triangulation, finest);
          triangulation.execute_coarsening_and_refinement();
        }
    }

    /// @return how many of the vertices and the centre of a cell are in a refinement region.
    template <int dim>
    unsigned int
    places_within(const RefinementRegion<dim>                             &region,
                  const typename Triangulation<dim>::active_cell_iterator &cell)
    {
      unsigned int n = region.where.value(cell->center()) > 0 ? 1 : 0;
      for (const unsigned int v : cell->vertex_indices())
        n += region.where.value(cell->vertex(v)) > 0 ? 1 : 0;
      return n;
    }
  } // namespace



  // Uniform refinement of all bodies, then cells at contact surfaces, then refinement regions.
  template <int dim>
  void
  Mesh<dim>::refine_initially(
    Triangulation<dim>                                       &triangulation,
    const std::vector<std::pair<std::string, BodyMesh<dim>>> &bodies,
    const MeshSettings<dim>                                  &settings,
    const std::vector<std::pair<std::string, std::string>>   &contact_surfaces) const
  {
    constexpr double children = GeometryInfo<dim>::max_children_per_cell;
    // All bodies are refined together, beginning with those that need more refinements: each pass
    // costs as much as there are cells in all of them.
    std::vector<unsigned int> times;
    for (unsigned int b = 0; b < bodies.size(); ++b)
      times.push_back(settings.refinements + my_least_levels[b] + bodies[b].second.refinements);
    refine_where(
      triangulation,
      *std::max_element(times.begin(), times.end()),
      [](const auto &) { return children; },
      // A body with n refinements takes part in the last n passes.
      [&](const auto &cell, const unsigned int left) { return times[body(cell)] >= left; });

    BoundaryIds surfaces;
    for (const auto &[slave, master] : contact_surfaces)
      for (const std::string &surface : {slave, master})
        if (!surface.empty())
          surfaces.insert(boundary_ids(surface).begin(), boundary_ids(surface).end());
    refine_where(
      triangulation,
      settings.contact_refinements,
      // Half of the children of a cell with a face on the surface have a face there as well.
      [](const auto &) { return children / 2; },
      [&](const auto &cell, auto) {
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary() && surfaces.count(cell->face(f)->boundary_id()) > 0)
            return true;
        return false;
      });

    for (const RefinementRegion<dim> &region : settings.refinement_regions)
      refine_where(
        triangulation,
        region.times,
        // All children of a cell inside the region will be refined again, of other cells at least
        // one.
        [&](const auto &cell) {
          return places_within<dim>(region, cell) > cell->n_vertices() ? children : 1.;
        },
        [&](const auto &cell, auto) {
          return places_within<dim>(region, cell) > 0 &&
                 (region.bodies.empty() ||
                  std::count(region.bodies.begin(), region.bodies.end(), names[body(cell)]));
        });
  }



  template void
  Mesh<2>::refine_initially(Triangulation<2> &,
                            const std::vector<std::pair<std::string, BodyMesh<2>>> &,
                            const MeshSettings<2> &,
                            const std::vector<std::pair<std::string, std::string>> &) const;
  template void
  Mesh<3>::refine_initially(Triangulation<3> &,
                            const std::vector<std::pair<std::string, BodyMesh<3>>> &,
                            const MeshSettings<3> &,
                            const std::vector<std::pair<std::string, std::string>> &) const;
} // namespace Signorini
