// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/reconstruction/surface_reconstruction.h"

#include "mesh_import/cells.h"
#include "mesh_import/reconstruction/curved_faces.h"
#include "mesh_import/reconstruction/facets.h"
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



    /// @return the distance [length] of a facet from the surface on which its corners are: the
    /// largest at vertices that were inserted, in the middles of lines, and in that of the facet.
    template <int dim>
    double
    distance_of(const RoundFaces<dim> &round, const unsigned int f, const FilePart<dim> &part)
    {
      const std::vector<unsigned int> &vertices = boundary_faces(part)[f].vertices;
      double result = round.surface.distance(center_of(vertices, part.vertices));
      for (const unsigned int v : vertices)
        result = std::max(result, round.surface.distance(part.vertices[v]));
      for (const auto &line : lines_of<dim>(vertices))
        result = std::max(result, round.surface.distance(center_of(line, part.vertices)));
      return result;
    }



    /// @return whether cells behind a round surface are too thin for it, or would be inverted.
    template <int dim>
    bool
    is_too_thin(const RoundFaces<dim>      &round,
                const FilePart<dim>        &part,
                const FacesByVertices<dim> &by_vertices)
    {
      Moved<dim> moved;
      for (const unsigned int f : round.faces)
        {
          const std::vector<unsigned int> &vertices = boundary_faces(part)[f].vertices;
          for (const unsigned int v : vertices)
            if (part.inserted[v])
              moved.vertices[v] = round.surface.closest(part.vertices[v]);
          for (const auto &line : lines_of<dim>(vertices))
            moved.middles[line] = round.surface.closest(center_of(line, part.vertices));
        }
      return std::any_of(round.faces.begin(), round.faces.end(), [&](const unsigned int f) {
        const auto &[depth, face] = by_vertices.at(boundary_faces(part)[f]);
        return is_thin(distance_of(round, f, part), depth) ||
               inverts_cells(face, moved, by_vertices);
      });
    }



    /// @return what smooth faces move if all of them become curved.
    template <int dim>
    Moved<dim>
    moved_by(const SmoothFaces<dim> &smooth, const FilePart<dim> &part)
    {
      Moved<dim> result;
      for (const SmoothFace<dim> &one : smooth.faces)
        {
          const std::vector<unsigned int> &v = boundary_faces(part)[one.face].vertices;
          for (const unsigned int vertex : v)
            if (part.inserted[vertex])
              result.vertices[vertex] = smooth.vertices[vertex];
          if (v.size() == dim) // a side of a simplex, or a line
            for (unsigned int i = 0; i < (dim == 2 ? 1 : 3); ++i)
              result.middles[sorted({v[i], v[(i + 1) % dim]})] = one.edges[i].value(0.5);
        }
      return result;
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



    /// What names a surface in the scene, for messages.
    template <int dim>
    constexpr const char *curved_boundaries =
      dim == 2 ? "name a circle in Curved boundaries" :
                 "name a sphere or cylinder in Curved boundaries";



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
    /// @param known for each face whether a round surface was recognised; set for faces that become
    /// curved here
    /// @param facets whose sagitta becomes the uncertainty of the reconstructed surface
    /// @return a line for the user, or none
    template <int dim>
    std::vector<std::string>
    smooth_surface(Triangulation<dim>         &triangulation,
                   const FilePart<dim>        &part,
                   const FacesByVertices<dim> &by_vertices,
                   const types::manifold_id    first,
                   std::vector<bool>          &known,
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
      const Moved<dim>          moved       = moved_by(smooth, part);
      for (const SmoothFace<dim> &one : smooth.faces)
        if (const auto &[depth, face] = by_vertices.at(boundary_faces(part)[one.face]);
            !is_thin(facets.sagitta[one.face], depth) && !inverts_cells(face, moved, by_vertices))
          {
            next = assign_manifold(one, by_vertices, next, part, triangulation);
            some.push_back(one.face);
            facets.sagitta[one.face] = one.uncertainty;
            uncertainty              = std::max(uncertainty, one.uncertainty);
            known[one.face]          = true;
            for (const unsigned int v : face->vertex_indices())
              face->vertex(v) = smooth.vertices[face->vertex_index(v)];
          }
      if (some.empty())
        return {};
      return {std::to_string(some.size()) + " facets of " + names_of(some, part) +
              " are reconstructed as smooth surfaces, with an accuracy of about " +
              short_text(uncertainty, 1) + "; Curved boundaries = none keeps the facets"};
    }



    /// @return for each boundary that may be meant as curved, as its facets meet at small angles
    /// that go on, a line for the user.
    /// @param known for each face whether it has become curved, or another line names it
    template <int dim>
    std::vector<std::string>
    flat_facets(const FacetGraph<dim>   &graph,
                const FilePart<dim>     &part,
                const std::vector<bool> &known,
                const Facets<dim>       &facets)
    {
      struct Bent
      {
        std::vector<unsigned int> faces;
        double                    angle = 0, sagitta = 0;
      };
      const std::vector<double>          angles = find_bent_facets(graph);
      std::map<types::boundary_id, Bent> of_boundaries;
      for (unsigned int f = 0; f < angles.size(); ++f)
        if (!known[f] && angles[f] > 0)
          {
            Bent &bent = of_boundaries[boundary_faces(part)[f].boundary_id];
            bent.faces.push_back(f);
            bent.angle   = std::max(bent.angle, angles[f]);
            bent.sagitta = std::max(bent.sagitta, facets.sagitta[f]);
          }
      std::vector<std::string> result;
      for (const auto &[id, bent] : of_boundaries)
        result.push_back(std::to_string(bent.faces.size()) + " facets of " +
                         names_of(bent.faces, part) + " stay flat, and meet at angles of up to " +
                         short_text(bent.angle, 2) +
                         " degrees: if a curved surface is meant, it is up to about " +
                         short_text(bent.sagitta, 2) + " from them; use smaller elements, or " +
                         curved_boundaries<dim>);
      return result;
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
        const bool is_round = automatic && !is_too_thin(round, part, by_vertices);
        double     distance = 0;
        for (const unsigned int f : round.faces)
          {
            known[f]          = true;
            facets.sagitta[f] = is_round ? 0. : round.sagitta;
            distance          = std::max(distance, distance_of(round, f, part));
          }
        if (!automatic)
          continue;
        const std::string facets_of = std::to_string(round.faces.size()) + " facets of " +
                                      names_of(round.faces, part),
                          surface = round.surface.description();
        if (!is_round)
          {
            result.notes.push_back(
              facets_of + " stay flat, up to " + short_text(distance, 2) + " from " + surface +
              ": the cells behind are too thin; use smaller elements there" +
              (round.surface.slope == 0 ? std::string(", or ") + curved_boundaries<dim> : ""));
            continue;
          }
        triangulation.set_manifold(id, *round.surface.manifold());
        assign_manifold(round, by_vertices, id++, part);
        result.notes.push_back(facets_of + " are taken for " + surface +
                               "; Curved boundaries = none keeps the facets");
      }
    if (automatic)
      {
        const auto smooth = smooth_surface(triangulation, part, by_vertices, id, known, facets);
        const auto flat   = flat_facets(graph, part, known, facets);
        result.is_curved  = id > 0 || !smooth.empty();
        result.notes.insert(result.notes.end(), smooth.begin(), smooth.end());
        result.notes.insert(result.notes.end(), flat.begin(), flat.end());
      }
    result.facets = steepest(facets, part);
    return result;
  }



  template SurfaceReconstruction
  reconstruct_surfaces(Triangulation<2> &, const FilePart<2> &, bool);
  template SurfaceReconstruction
  reconstruct_surfaces(Triangulation<3> &, const FilePart<3> &, bool);
} // namespace Signorini
