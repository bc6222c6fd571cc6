// SPDX-License-Identifier: Apache-2.0
#include "mesh/mesh.h"
#include <signorini/mesh/generator.h>
#include <signorini/parameters/raw.h>

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  // Throw SceneError if the scene asks for what meshes with triangles or tetrahedra cannot do.
  template <int dim>
  void
  Mesh<dim>::check_for_simplices(const std::vector<std::pair<std::string, BodyMesh<dim>>> &bodies,
                                 const MeshSettings<dim> &settings) const
  {
    const std::string body = names[std::find(is_of_simplices.begin(), is_of_simplices.end(), true) -
                                   is_of_simplices.begin()],
                      cure = ", but the cells of body '" + body + "' are " +
                             word_of_cells(dim, true) +
                             ", and no body beside such a one is refined: set Bodies/" + body +
                             "/Cells = " + word_of_cells(dim, false);
    if (settings.distribution == Distribution::p4est)
      throw SceneError("Mesh/Distribution = p4est" + cure);
    if (settings.refinements > 0 || settings.contact_refinements > 0 ||
        !settings.refinement_regions.empty())
      throw SceneError("Mesh has refinements" + cure);
    for (const auto &[name, one] : bodies)
      if (one.refinements > 0)
        throw SceneError("Bodies/" + name + "/Refinements = " + std::to_string(one.refinements) +
                         cure);
  }



  // Throw SceneError if slave and master of a pair share faces without being the same boundary.
  template <int dim>
  void
  Mesh<dim>::check_slaves_and_masters(
    const std::vector<std::pair<std::string, std::string>> &contact_surfaces) const
  {
    for (const auto &[slave, master] : contact_surfaces)
      if (!master.empty() && slave != master)
        for (const types::boundary_id id : boundary_ids(slave))
          if (boundary_ids(master).count(id) > 0)
            throw SceneError(
              "a contact pair has the slave '" + slave + "' and the master '" + master +
              "', which share faces; for self-contact set Master to the same boundary as Slave");
  }



  template void
  Mesh<2>::check_for_simplices(const std::vector<std::pair<std::string, BodyMesh<2>>> &,
                               const MeshSettings<2> &) const;
  template void
  Mesh<3>::check_for_simplices(const std::vector<std::pair<std::string, BodyMesh<3>>> &,
                               const MeshSettings<3> &) const;
  template void
  Mesh<2>::check_slaves_and_masters(const std::vector<std::pair<std::string, std::string>> &) const;
  template void
  Mesh<3>::check_slaves_and_masters(const std::vector<std::pair<std::string, std::string>> &) const;
} // namespace Signorini
