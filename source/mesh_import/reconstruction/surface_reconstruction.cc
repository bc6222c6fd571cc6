// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/reconstruction/surface_reconstruction.h"

#include "geometry/cell_size.h"
#include "mesh_import/cells.h"
#include "mesh_import/reconstruction/curved_faces.h"
#include <signorini/base/text.h>
#include <signorini/parameters/section.h>

#include <algorithm>
#include <map>
#include <set>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    const std::vector<CellData<dim - 1>> &
    boundary_faces(const FilePart<dim> &part)
    {
      if constexpr (dim == 2)
        return part.faces.boundary_lines;
      else
        return part.faces.boundary_quads;
    }



    /// The boundary faces of a triangulation by their sorted vertices, with the depth of their
    /// cells.
    template <int dim>
    struct FacesByVertices
    {
      using Face = typename Triangulation<dim>::face_iterator;

      std::map<std::vector<unsigned int>, std::pair<double, Face>> faces;

      explicit FacesByVertices(const Triangulation<dim> &triangulation)
      {
        for (const auto &cell : triangulation.active_cell_iterators())
          for (const unsigned int f : cell->face_indices())
            if (const Face face = cell->face(f); face->at_boundary())
              {
                std::vector<unsigned int> vertices;
                for (const unsigned int v : face->vertex_indices())
                  vertices.push_back(face->vertex_index(v));
                faces[sorted(vertices)] = {depth_behind(cell, f), face};
              }
      }

      const std::pair<double, Face> &
      at(const CellData<dim - 1> &face) const
      {
        return faces.at(sorted(face.vertices));
      }
    };



    /// @return whether any of these faces has a cell so thin (sagitta above a fifth of its depth)
    /// that the curved surface would come close to the opposite side of the cell.
    template <int dim>
    bool
    is_too_thin(const double                          sagitta,
                const std::vector<unsigned int>      &some,
                const std::vector<CellData<dim - 1>> &faces,
                const FacesByVertices<dim>           &by_vertices)
    {
      constexpr double thin = 0.2; // sagitta by depth
      return std::any_of(some.begin(), some.end(), [&](const unsigned int f) {
        return sagitta > thin * by_vertices.at(faces[f]).first;
      });
    }



    /// @return the names of the boundaries that have any of these faces, for messages.
    template <int dim>
    std::string
    names_of(const std::vector<unsigned int> &some, const FilePart<dim> &part)
    {
      std::set<unsigned int> names;
      for (const unsigned int f : some)
        for (const unsigned int name : part.names_of_ids[boundary_faces(part)[f].boundary_id])
          names.insert(name);
      std::vector<std::string> words;
      for (const unsigned int name : names)
        words.push_back(part.boundaries[name]);
      return join(words);
    }



    /// Give the faces of a round surface, and their lines, the manifold id, and move inserted
    /// vertices onto the surface. Vertices of the file keep their positions.
    template <int dim>
    void
    assign_manifold(const RoundFaces<dim>      &round,
                    const FacesByVertices<dim> &by_vertices,
                    const types::manifold_id    id,
                    const FilePart<dim>        &part)
    {
      for (const unsigned int f : round.faces)
        {
          const auto &face = by_vertices.at(boundary_faces(part)[f]).second;
          face->set_all_manifold_ids(id);
          for (const unsigned int v : face->vertex_indices())
            if (part.inserted[face->vertex_index(v)])
              face->vertex(v) = round.surface.closest(face->vertex(v));
        }
    }



    /// Give a face on a smooth surface its manifold. Lines that have one already (of a round
    /// surface, or of the face that came before, which has the same curve there) keep it. Triangles
    /// are curved by the points in the middle of their edges alone.
    /// @param id the next manifold id
    /// @return the next manifold id
    template <int dim>
    types::manifold_id
    assign_manifold(const SmoothFace<dim>      &smooth,
                    const FacesByVertices<dim> &by_vertices,
                    types::manifold_id          id,
                    const FilePart<dim>        &part,
                    Triangulation<dim>         &triangulation)
    {
      const CellData<dim - 1> &corners = boundary_faces(part)[smooth.face];
      const auto              &face    = by_vertices.at(corners).second;
      if constexpr (dim == 3)
        if (const auto &v = corners.vertices; v.size() == 3)
          {
            for (unsigned int i = 0; i < 3; ++i)
              for (unsigned int l = 0; l < 3; ++l)
                if (const auto line = face->line(l);
                    line->manifold_id() == numbers::flat_manifold_id &&
                    sorted({line->vertex_index(0), line->vertex_index(1)}) ==
                      sorted({v[i], v[(i + 1) % 3]}))
                  {
                    triangulation.set_manifold(id,
                                               ParabolicLine<dim>(smooth.edges[i].value(0.5) -
                                                                  line->center()));
                    line->set_manifold_id(id++);
                  }
            return id;
          }
      triangulation.set_manifold(id, CurvedFace<dim>(smooth.edges));
      face->set_manifold_id(id);
      if constexpr (dim == 3)
        for (unsigned int l = 0; l < face->n_lines(); ++l)
          if (face->line(l)->manifold_id() == numbers::flat_manifold_id)
            face->line(l)->set_manifold_id(id);
      return id + 1;
    }



    /// Reconstruct smooth surfaces where no round one was recognised: give each face manifolds of
    /// its own, with ids from `first` on, and move its vertices onto the surface.
    /// @param known for each face whether a round surface was recognised
    /// @param facets whose sagitta becomes the uncertainty of the reconstructed surface
    /// @return a line for the user, or none
    template <int dim>
    std::vector<std::string>
    smooth_surface(Triangulation<dim>         &triangulation,
                   const FilePart<dim>        &part,
                   const FacesByVertices<dim> &by_vertices,
                   const types::manifold_id    first,
                   const std::vector<bool>    &known,
                   Facets<dim>                &facets)
    {
      // The graph of the vertices after round surfaces have moved some of them.
      const FacetGraph<dim>     graph(boundary_faces(part),
                                  triangulation.get_vertices(),
                                  part.inserted);
      const SmoothFaces<dim>    smooth = find_smooth_faces(graph, known);
      std::vector<unsigned int> some;
      double                    uncertainty = 0;
      types::manifold_id        next        = first;
      for (const SmoothFace<dim> &one : smooth.faces)
        if (!is_too_thin(facets.sagitta[one.face], {one.face}, boundary_faces(part), by_vertices))
          {
            next = assign_manifold(one, by_vertices, next, part, triangulation);
            some.push_back(one.face);
            facets.sagitta[one.face] = one.uncertainty;
            uncertainty              = std::max(uncertainty, one.uncertainty);
            const auto &face         = by_vertices.at(boundary_faces(part)[one.face]).second;
            for (const unsigned int v : face->vertex_indices())
              face->vertex(v) = smooth.vertices[face->vertex_index(v)];
          }
      if (some.empty())
        return {};
      return {std::to_string(some.size()) + " facets of " + names_of(some, part) +
              " are reconstructed as smooth surfaces, with an accuracy of about " +
              short_text(uncertainty, 1) + "; Curved boundaries = none keeps the facets"};
    }



    /// @return for each boundary name the facet with the largest ratio of sagitta to its diagonal.
    template <int dim>
    std::vector<FacetHeight>
    steepest(const Facets<dim> &facets, const FilePart<dim> &part)
    {
      std::vector<FacetHeight> result(part.boundaries.size());
      for (unsigned int f = 0; f < facets.sagitta.size(); ++f)
        {
          const auto       &face = boundary_faces(part)[f];
          const FacetHeight one{facets.sagitta[f],
                                part.vertices[face.vertices.front()].distance(
                                  part.vertices[face.vertices.back()])};
          for (const unsigned int name : part.names_of_ids[face.boundary_id])
            if (one.slope() > result[name].slope())
              result[name] = one;
        }
      return result;
    }
  } // namespace



  // Round surfaces are recognised first, because their manifolds are exact; what is left may be
  // smooth. Without `automatic` the facets are only measured.
  template <int dim>
  SurfaceReconstruction
  reconstruct_surfaces(Triangulation<dim>  &triangulation,
                       const FilePart<dim> &part,
                       const bool           automatic)
  {
    // Facets of round surfaces become curved unless cells are too thin; without `automatic` their
    // distance is reported.
    const FacetGraph<dim>      graph(boundary_faces(part), part.vertices, part.inserted);
    Facets<dim>                facets = find_round_faces(graph);
    const FacesByVertices<dim> by_vertices(triangulation);
    SurfaceReconstruction      result;
    types::manifold_id         id = 0;
    std::vector<bool>          known(boundary_faces(part).size(), false);
    for (const RoundFaces<dim> &round : facets.round)
      {
        const bool is_round =
          automatic && !is_too_thin(round.sagitta, round.faces, boundary_faces(part), by_vertices);
        for (const unsigned int f : round.faces)
          {
            known[f]          = true;
            facets.sagitta[f] = is_round ? 0. : round.sagitta;
          }
        if (!is_round)
          continue;
        triangulation.set_manifold(id, *round.surface.manifold());
        assign_manifold(round, by_vertices, id++, part);
        result.notes.push_back(std::to_string(round.faces.size()) + " facets of " +
                               names_of(round.faces, part) + " are taken for " +
                               round.surface.description() +
                               "; Curved boundaries = none keeps the facets");
      }
    if (automatic)
      for (const std::string &note :
           smooth_surface(triangulation, part, by_vertices, id, known, facets))
        result.notes.push_back(note);
    result.facets = steepest(facets, part);
    return result;
  }



  template SurfaceReconstruction
  reconstruct_surfaces(Triangulation<2> &, const FilePart<2> &, bool);
  template SurfaceReconstruction
  reconstruct_surfaces(Triangulation<3> &, const FilePart<3> &, bool);
} // namespace Signorini
