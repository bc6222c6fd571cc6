// SPDX-License-Identifier: Apache-2.0
#include "mesh/mesh.h"
#include "mesh/transformed_manifold.h"
#include "mesh_import/pieces.h"

#include <algorithm>
#include <sstream>

// Part of class Mesh: merging the coarse meshes of all bodies into one.

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // A fully distributed triangulation ends at its ghost cells: where their neighbours are
    // missing, it has artificial boundary faces with id 0, which must not be confused with ids of
    // the scene.
    constexpr types::boundary_id first_boundary_id = 1;

    /// Add offsets to the vertices and manifold ids of cells or faces.
    template <typename Object>
    void
    shift(std::vector<Object>     &objects,
          const unsigned int       first_vertex,
          const types::manifold_id first_manifold)
    {
      for (Object &object : objects)
        {
          for (unsigned int &vertex : object.vertices)
            vertex += first_vertex;
          if (object.manifold_id != numbers::flat_manifold_id)
            object.manifold_id += first_manifold;
        }
    }

    /// Add an offset to the boundary ids of faces.
    template <typename Object>
    void
    shift_boundary(std::vector<Object> &objects, const types::boundary_id first)
    {
      for (Object &object : objects)
        if (object.boundary_id != numbers::internal_face_boundary_id)
          object.boundary_id += first;
    }

    /// Append a list to another one.
    template <typename T>
    void
    append(std::vector<T> &to, const std::vector<T> &from)
    {
      to.insert(to.end(), from.begin(), from.end());
    }

    /// @return the diagonal of the bounding box of some points.
    template <int dim>
    double
    diagonal_of(const std::vector<Point<dim>> &points)
    {
      const BoundingBox<dim> box(points);
      return box.get_boundary_points().first.distance(box.get_boundary_points().second);
    }
  } // namespace



  /// Assign the next material ids to the cells of a body: one for the body itself, and one for each
  /// of its sets of cells with a material of their own, of which later ones have priority.
  template <int dim>
  void
  Mesh<dim>::number_materials(std::vector<CellData<dim>> &cells, const BodyMesh<dim> &body)
  {
    own_materials.push_back(n_materials());
    bodies_of_materials.push_back(names.size());
    for (CellData<dim> &cell : cells)
      cell.material_id = own_materials.back();
    for (const std::string &set : body.cells_of_materials)
      {
        for (const unsigned int c : body.generator->cell_set(set))
          cells[c].material_id = n_materials();
        bodies_of_materials.push_back(names.size());
      }
  }



  // Body by body: generate, transform, and append with offsets of vertices, manifold ids, boundary
  // ids and material ids. Bodies share no vertices.
  template <int dim>
  CoarseMesh<dim>
  Mesh<dim>::merge(const std::vector<std::pair<std::string, BodyMesh<dim>>> &bodies,
                   const bool                                                merges_cells)
  {
    CoarseMesh<dim> all;
    for (const auto &[name, body] : bodies)
      {
        // Generate the coarse mesh, with merged cells if it can be refined again, and transform it.
        my_least_levels.push_back(merges_cells ? body.generator->possible_merges() : 0);
        CoarseMesh<dim> one        = body.generator->generate_merged(my_least_levels.back());
        bool            has_curves = body.generator->curved();
        const double    size       = diagonal_of(one.vertices);
        if (!body.transformation.empty())
          has_curves = transform(one, has_curves, body.transformation);
        const double growth = diagonal_of(one.vertices) / size;
        is_curved.push_back(has_curves);
        is_of_simplices.push_back(one.cells[0].vertices.size() == dim + 1);
        degree_of_body.push_back(has_curves ? body.degree : 1);
        if (has_curves)
          degree_of_surfaces = 4;

        my_temperature.append(one.cells, body.generator->temperature());
        // Manifolds, vertices and boundary ids continue those of the bodies before.
        const types::manifold_id first_manifold =
          all.manifolds.empty() ? 0 : all.manifolds.rbegin()->first + 1;
        for (const auto &[id, manifold] : one.manifolds)
          all.manifolds[first_manifold + id] = manifold;

        shift(one.cells, all.vertices.size(), first_manifold);
        shift(one.faces.boundary_lines, all.vertices.size(), first_manifold);
        shift(one.faces.boundary_quads, all.vertices.size(), first_manifold);
        const types::boundary_id first_id = first_boundary_id + n_ids;
        shift_boundary(one.faces.boundary_lines, first_id);
        shift_boundary(one.faces.boundary_quads, first_id);
        n_ids += one.n_boundary_ids();
        first_cells.push_back(all.cells.size());
        generators.push_back(body.generator);
        number_materials(one.cells, body);

        append(all.vertices, one.vertices);
        append(all.cells, one.cells);
        append(all.faces.boundary_lines, one.faces.boundary_lines);
        append(all.faces.boundary_quads, one.faces.boundary_quads);
        // Names of boundaries, with their facets in the scale of the transformed mesh.
        for (unsigned int i = 0; i < one.boundaries.size(); ++i)
          {
            boundary_names.push_back(name + "." + one.boundaries[i]);
            body_of_boundary.push_back(names.size());
            facets.push_back(one.facets.empty() ? FacetHeight() : one.facets[i]);
            facets.back().height *= growth;
            facets.back().length *= growth;
            ids_of_names.emplace_back();
            for (const types::boundary_id id : one.ids_of(i))
              ids_of_names.back().insert(first_id + id);
          }
        names.push_back(name);
      }
    return all;
  }



  // Pieces of one body are named by their number and centre if there are several.
  template <int dim>
  void
  Mesh<dim>::find_pieces(const CoarseMesh<dim> &coarse)
  {
    piece_of_coarse_cell = pieces_of(coarse.cells, coarse.vertices.size());
    // Pieces are numbered in the order of their first cells, so that a cell with the next number
    // begins a new piece.
    std::vector<unsigned int> of_body(n_bodies());
    for (unsigned int c = 0; c < coarse.cells.size(); ++c)
      {
        const Point<dim> &first = coarse.vertices[coarse.cells[c].vertices[0]];
        if (piece_of_coarse_cell[c] == my_pieces.size())
          {
            my_pieces.push_back({bodies_of_materials[coarse.cells[c].material_id],
                                 "",
                                 BoundingBox<dim>({first, first})});
            ++of_body[my_pieces.back().body];
          }
        for (const unsigned int v : coarse.cells[c].vertices)
          my_pieces[piece_of_coarse_cell[c]].extent.merge_with(
            BoundingBox<dim>({coarse.vertices[v], coarse.vertices[v]}));
      }
    // Pieces of one body follow each other; k counts within the body.
    for (unsigned int i = 0, k = 1; i < my_pieces.size(); ++i, ++k)
      {
        BodyPiece<dim> &piece = my_pieces[i];
        if (i > 0 && my_pieces[i - 1].body != piece.body)
          k = 1;
        piece.name = names[piece.body];
        if (of_body[piece.body] > 1)
          {
            std::ostringstream place;
            place << piece.extent.center();
            piece.name += ", piece " + std::to_string(k) + " of " +
                          std::to_string(of_body[piece.body]) + " about (" + place.str() + ")";
          }
      }
  }



  template CoarseMesh<2>
  Mesh<2>::merge(const std::vector<std::pair<std::string, BodyMesh<2>>> &, bool);
  template CoarseMesh<3>
  Mesh<3>::merge(const std::vector<std::pair<std::string, BodyMesh<3>>> &, bool);
  template void
  Mesh<2>::find_pieces(const CoarseMesh<2> &);
  template void
  Mesh<3>::find_pieces(const CoarseMesh<3> &);
} // namespace Signorini
