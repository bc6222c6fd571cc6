// SPDX-License-Identifier: Apache-2.0
#include <signorini/geometry/coarse_mesh.h>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <tuple>
#include <utility>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Remove the entries of interior faces and lines without manifold, which have no effect.
    template <typename Object>
    void
    strip_settings(std::vector<Object> &objects, const bool are_faces)
    {
      // In 3D the boundary id of a line has no meaning here; "none" never contradicts that of
      // another face.
      if (!are_faces)
        for (Object &object : objects)
          object.boundary_id = numbers::internal_face_boundary_id;
      objects.erase(std::remove_if(objects.begin(),
                                   objects.end(),
                                   [](const Object &object) {
                                     return object.boundary_id ==
                                              numbers::internal_face_boundary_id &&
                                            object.manifold_id == numbers::flat_manifold_id;
                                   }),
                    objects.end());
    }



    /// Throws if a boundary face has no name: an error of a mesh generator.
    template <typename Face>
    void
    check_names(const std::vector<Face> &faces, const unsigned int n_names)
    {
      for (const Face &face : faces)
        AssertThrow(face.boundary_id == numbers::internal_face_boundary_id ||
                      face.boundary_id < n_names,
                    ExcInternalError("A mesh generator left a boundary face without a name."));
    }
  } // namespace



  // Manifold ids are numbered consecutively in the order of their occurrence.
  template <int dim>
  CoarseMesh<dim>
  CoarseMesh<dim>::from_triangulation(const Triangulation<dim>                     &triangulation,
                                      const std::vector<std::string>               &boundaries,
                                      const std::vector<std::vector<unsigned int>> &names_of_ids)
  {
    Assert(triangulation.n_levels() == 1, ExcInternalError());
    CoarseMesh<dim> mesh;
    mesh.boundaries   = boundaries;
    mesh.names_of_ids = names_of_ids;
    std::tie(mesh.vertices, mesh.cells, mesh.faces) =
      GridTools::get_coarse_mesh_description(triangulation);
    strip_settings(mesh.faces.boundary_lines, dim == 2);
    strip_settings(mesh.faces.boundary_quads, dim == 3);
    if (dim == 2)
      check_names(mesh.faces.boundary_lines, mesh.n_boundary_ids());
    else
      check_names(mesh.faces.boundary_quads, mesh.n_boundary_ids());

    // Ids of the triangulation may have gaps; the clones of its manifolds are stored once for each
    // id that occurs, in the order of occurrence. The flat manifold keeps its special id and needs
    // no object.
    std::map<types::manifold_id, types::manifold_id> new_ids{
      {numbers::flat_manifold_id, numbers::flat_manifold_id}};
    mesh.map_manifold_ids([&](const types::manifold_id id) {
      const auto [entry, is_new] = new_ids.insert({id, mesh.manifolds.size()});
      if (is_new)
        mesh.manifolds[entry->second] = triangulation.get_manifold(id).clone();
      return entry->second;
    });
    return mesh;
  }



  template <int dim>
  std::set<types::boundary_id>
  CoarseMesh<dim>::ids_of(const unsigned int name) const
  {
    // Without a table each name has the id of its number. With one, an id is a set of faces that
    // all names in its row have in common, so that names may overlap.
    if (names_of_ids.empty())
      return {name};
    std::set<types::boundary_id> ids;
    for (types::boundary_id id = 0; id < names_of_ids.size(); ++id)
      if (std::count(names_of_ids[id].begin(), names_of_ids[id].end(), name) > 0)
        ids.insert(id);
    return ids;
  }



  template struct CoarseMesh<2>;
  template struct CoarseMesh<3>;
} // namespace Signorini
