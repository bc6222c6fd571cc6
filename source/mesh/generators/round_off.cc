#include <signorini/mesh/generators/facets.h>
#include <signorini/mesh/generators/round_faces.h>
#include <signorini/mesh/generators/round_off.h>
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
                faces[sorted(vertices)] = {cell->measure() / face->measure(), face};
              }
      }

      const std::pair<double, Face> &
      at(const CellData<dim - 1> &face) const
      {
        return faces.at(sorted(face.vertices));
      }
    };



    /// Cells that are so thin that the surface would come near their other side.
    template <int dim>
    bool
    is_too_thin(const RoundFaces<dim>                &round,
                const std::vector<CellData<dim - 1>> &faces,
                const FacesByVertices<dim>           &by_vertices)
    {
      constexpr double thin = 0.2; // sagitta by depth
      return std::any_of(round.faces.begin(), round.faces.end(), [&](const unsigned int f) {
        return round.sagitta > thin * by_vertices.at(faces[f]).first;
      });
    }



    /// Give facets that stand for a round surface that for a manifold.
    /// @return the names of their boundaries
    template <int dim>
    std::vector<std::string>
    give_manifold(const RoundFaces<dim>      &round,
                  const FacesByVertices<dim> &by_vertices,
                  const types::manifold_id    id,
                  const FilePart<dim>        &part)
    {
      std::set<unsigned int> names;
      for (const unsigned int f : round.faces)
        {
          const auto &face = by_vertices.at(boundary_faces(part)[f]).second;
          face->set_all_manifold_ids(id);
          for (const unsigned int v : face->vertex_indices())
            if (part.made[face->vertex_index(v)])
              face->vertex(v) = round.surface.closest(face->vertex(v));
          for (const unsigned int name : part.names_of_ids[face->boundary_id()])
            names.insert(name);
        }
      std::vector<std::string> words;
      for (const unsigned int name : names)
        words.push_back(part.boundaries[name]);
      return words;
    }



    template <int dim>
    void
    keep_facets(const RoundFaces<dim> &round, Facets<dim> &facets)
    {
      for (const unsigned int f : round.faces)
        facets.sagitta[f] = round.sagitta;
    }



    /// The largest sagitta of each boundary.
    template <int dim>
    std::vector<double>
    sagittas_of(const Facets<dim> &facets, const FilePart<dim> &part)
    {
      std::vector<double> result(part.boundaries.size(), 0.);
      for (unsigned int f = 0; f < facets.sagitta.size(); ++f)
        for (const unsigned int name : part.names_of_ids[boundary_faces(part)[f].boundary_id])
          result[name] = std::max(result[name], facets.sagitta[f]);
      return result;
    }
  } // namespace



  template <int dim>
  Rounding
  round_off(Triangulation<dim> &triangulation, const FilePart<dim> &part, const bool automatic)
  {
    Facets<dim> facets = find_round_faces(boundary_faces(part), part.vertices, part.made);
    const FacesByVertices<dim> by_vertices(triangulation);
    Rounding                   result;
    for (const RoundFaces<dim> &round : facets.round)
      if (automatic && !is_too_thin(round, boundary_faces(part), by_vertices))
        {
          const types::manifold_id id = result.notes.size();
          triangulation.set_manifold(id, *round.surface.manifold());
          result.notes.push_back(std::to_string(round.faces.size()) + " facets of " +
                                 join(give_manifold(round, by_vertices, id, part)) +
                                 " are taken for " + round.surface.description() +
                                 "; Curved boundaries = none keeps the facets");
        }
      else
        keep_facets(round, facets);
    result.sagittas = sagittas_of(facets, part);
    return result;
  }



  template Rounding
  round_off(Triangulation<2> &, const FilePart<2> &, bool);
  template Rounding
  round_off(Triangulation<3> &, const FilePart<3> &, bool);
} // namespace Signorini
