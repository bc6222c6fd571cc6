// SPDX-License-Identifier: Apache-2.0
#include "output/results.h"

#include <deal.II/base/utilities.h>

#include <Trilinos_version.h>

#include <cmath>
#include <map>

namespace Signorini
{
  using namespace dealii;

  // Faces towards refined ghost cells count once.
  template <int dim>
  Json
  shares_of_ranks(const Elasticity<dim>                  &elasticity,
                  const std::vector<ContactSurface<dim>> &surfaces)
  {
    std::map<std::string, unsigned int> own = {{"dofs", elasticity.owned().n_elements()},
                                               {"cells", 0},
                                               {"ghost_cells", 0},
                                               {"ghost_faces", 0},
                                               {"slave_faces", 0},
                                               {"contact_points", 0}};
    for (const auto &cell : elasticity.mesh().triangulation().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          ++own["cells"];
          for (const unsigned int f : cell->face_indices())
            // If the neighbour is divided, its first child at this face is representative: all
            // children of one parent are usually on one rank.
            if (!cell->at_boundary(f))
              own["ghost_faces"] += cell->neighbor(f)->has_children() ?
                                      cell->neighbor_child_on_subface(f, 0)->is_ghost() :
                                      cell->neighbor(f)->is_ghost();
        }
      else if (cell->is_ghost())
        ++own["ghost_cells"];
    for (const ContactSurface<dim> &surface : surfaces)
      {
        own["slave_faces"] += surface.faces;
        own["contact_points"] += surface.points.size();
      }
    Json result;
    for (const auto &[name, number] : own)
      result[name] = Utilities::MPI::all_gather(elasticity.mesh().communicator(), number);
    return result;
  }



  Json
  peak_memory(const MPI_Comm comm)
  {
    Utilities::System::MemoryStats memory;
    Utilities::System::get_memory_stats(memory);
    // VmHWM is the largest resident memory so far, in kB.
    return Json(Utilities::MPI::all_gather(comm, std::round(memory.VmHWM / 1024.)));
  }



  Json
  library_versions()
  {
    return {{"deal.II", DEAL_II_PACKAGE_VERSION}, {"Trilinos", TRILINOS_VERSION_STRING}};
  }



  template Json
  shares_of_ranks(const Elasticity<2> &, const std::vector<ContactSurface<2>> &);
  template Json
  shares_of_ranks(const Elasticity<3> &, const std::vector<ContactSurface<3>> &);
} // namespace Signorini
