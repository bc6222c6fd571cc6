// SPDX-License-Identifier: Apache-2.0
#include "mesh/generators/file.h"

#include "geometry/cell_size.h"
#include "mesh_import/cells.h"
#include "mesh_import/division/chosen_cells.h"
#include "mesh_import/division/subdivisions.h"
#include "mesh_import/import_steps.h"
#include "mesh_import/pieces.h"
#include "mesh_import/reconstruction/surface_reconstruction.h"
#include <signorini/parameters/section.h>

#include <deal.II/base/bounding_box.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Throw SceneError if a group does not exist.
    void
    check_groups(const MeshFile &file, const std::vector<std::string> &wanted)
    {
      std::vector<std::string> names;
      for (const auto &group : file.groups)
        names.push_back(group.name);
      for (const std::string &name : wanted)
        if (std::find(names.begin(), names.end(), name) == names.end())
          throw SceneError("has no face set '" + name + "'; it has " +
                           (names.empty() ? "no names" : join(names)));
    }



    /// Append messages.
    void
    append(const std::vector<std::string> &more, std::vector<std::string> &notes)
    {
      notes.insert(notes.end(), more.begin(), more.end());
    }



    /// Throw SceneError if a cell is inverted after vertices have been moved onto curved surfaces.
    template <int dim>
    void
    check_not_folded(const Triangulation<dim> &triangulation, const FilePart<dim> &part)
    {
      for (const auto &cell : triangulation.active_cell_iterators())
        {
          std::vector<Point<dim>> corners;
          for (const unsigned int v : cell->vertex_indices())
            corners.push_back(cell->vertex(v));
          for (const double volume : determinants_at_corners(corners))
            if (!(volume > 0)) // also NaN
              throw SceneError(
                "folds element " +
                std::to_string(part.elements[cell->active_cell_index()]->number) +
                ", which is too large for the curvature; use smaller elements there");
        }
    }



    /// @return the temperature of each vertex of the part; empty if no field is named. Throws
    /// SceneError if the field does not exist, or lacks a value.
    template <int dim>
    std::vector<double>
    temperatures_of(const MeshFile &file, const FilePart<dim> &part, const std::string &name)
    {
      if (name.empty())
        return {};
      const auto found = file.fields.find(name);
      if (found == file.fields.end())
        {
          std::vector<std::string> names;
          for (const auto &field : file.fields)
            names.push_back(field.first);
          throw SceneError("has no nodal data of that name; it has " +
                           (names.empty() ? "none" : join(names)));
        }
      std::vector<double> result;
      for (unsigned int v = 0; v < part.vertices.size(); ++v)
        {
          const unsigned int node = part.file_nodes[v];
          result.push_back(node < found->second.size() ? found->second[node] :
                                                         std::numeric_limits<double>::quiet_NaN());
          if (!std::isfinite(result.back()))
            throw SceneError("has no temperature at the node at " + text_of(part.vertices[v]));
        }
      return result;
    }



    /// @return the cells of each group, as indices into the part.
    template <int dim>
    std::map<std::string, std::vector<unsigned int>>
    cell_sets_of(const MeshFile &file, const FilePart<dim> &part)
    {
      // Elements of the part are pointers into the list of the file, so that their index is a
      // difference of pointers. Elements outside of the part stay without a cell.
      constexpr unsigned int    none = -1;
      std::vector<unsigned int> cell_of(file.elements.size(), none);
      for (unsigned int c = 0; c < part.elements.size(); ++c)
        cell_of[part.elements[c] - file.elements.data()] = c;
      std::map<std::string, std::vector<unsigned int>> result;
      for (const MeshFile::Group &group : file.groups)
        for (const unsigned int e : group.elements)
          if (cell_of[e] != none)
            result[group.name].push_back(cell_of[e]);
      return result;
    }



    /// Rotate plane cells in the xz or yz plane of the file into the xy plane.
    /// @return a message about it, or none
    std::vector<std::string>
    flatten(MeshFile &file)
    {
      // The bounding box of all plane cells tells in which coordinate plane they are.
      BoundingBox<3> box;
      bool           has_cells = false;
      for (const auto &element : file.elements)
        if (dimension_of(element.shape) == 2)
          for (const unsigned int node : element.nodes)
            {
              const BoundingBox<3> point({file.nodes[node], file.nodes[node]});
              if (has_cells)
                box.merge_with(point);
              else
                box = point;
              has_cells = true;
            }
      // A side is flat if its length is of the size of rounding relative to the coordinates; files
      // of plane meshes usually have exact zeros.
      constexpr double rounding = 1e-10;
      const double     size     = has_cells ? box.get_boundary_points().second.norm() +
                                        box.get_boundary_points().first.norm() :
                                              0.;
      const auto       is_flat  = [&](const unsigned int d) {
        return box.side_length(d) <= rounding * size;
      };
      if (!has_cells || is_flat(2) || (!is_flat(0) && !is_flat(1)))
        return {};
      // Both rotations preserve the orientation in space: (x, z, -y) or (y, z, x).
      const bool across_y = is_flat(1);
      for (Point<3> &node : file.nodes)
        node =
          across_y ? Point<3>(node[0], node[2], -node[1]) : Point<3>(node[1], node[2], node[0]);
      return {"the cells lie in the plane of " + std::string(across_y ? "x and z" : "y and z") +
              " of the file, which become x and y of the model"};
    }



    /// Throw SceneError if the cells of a part are not all of one shape that needs no division.
    /// @return whether they are triangles or tetrahedra
    template <int dim>
    bool
    are_simplices(const MeshFile &file, const std::vector<unsigned int> &cells)
    {
      const auto n_of = [&](const MeshFile::Shape shape) -> std::size_t {
        return std::count_if(cells.begin(), cells.end(), [&](const unsigned int c) {
          return file.elements[c].shape == shape;
        });
      };
      const std::size_t n_simplices = n_of(simplex_shape<dim>);
      if (n_of(cell_shape<dim>) == cells.size() || n_simplices == cells.size())
        return n_simplices > 0;
      const std::string simplices = word_of_cells(dim, true), others = word_of_cells(dim, false);
      throw SceneError("has " + std::to_string(n_simplices) + " " + simplices + " among " +
                       std::to_string(cells.size()) + " cells; a body may consist of " + simplices +
                       " or " + others + ", of both" + (dim == 3 ? ", wedges or pyramids" : "") +
                       " only if all are of second order: set Cells = " + others);
    }



    /// @return whether a list contains a name.
    bool
    is_in(const std::string &name, const std::vector<std::string> &names)
    {
      return std::find(names.begin(), names.end(), name) != names.end();
    }
  } // namespace



  bool
  file_exists(const std::string &name)
  {
    std::error_code is_no_name;
    return std::filesystem::exists(name, is_no_name);
  }



  std::string
  find_beside_scene(const std::string &file, const std::string &folder)
  {
    if (file_exists(file) || std::filesystem::path(file).is_absolute())
      return file;
    const auto candidate = std::filesystem::path(folder) / file;
    return file_exists(candidate.string()) ? candidate.string() : file;
  }



  template <int dim>
  void
  FileMesh<dim>::add_sets(MeshFile &all, std::string &key) const
  {
    const NumberedSets sets(all, cells_of_part(all, dim, selection.part));
    key = "Node sets";
    sets.add_nodes(node_set_text, all);
    key = "Face sets";
    sets.add_faces(face_set_text, all);
    key = "Cell sets";
    sets.add_cells(cell_set_text, all);
  }



  // Simplices of first order lock, and lose an order against the hypercubes that they become.
  template <int dim>
  bool
  FileMesh<dim>::keeps_simplices(const MeshFile                  &all,
                                 const std::vector<unsigned int> &chosen,
                                 const std::string               &needs_hypercubes,
                                 std::vector<std::string>        &notes) const
  {
    const std::string simplices = word_of_cells(dim, true), hypercubes = word_of_cells(dim, false);
    const auto        are_second_order = [&](const unsigned int c) {
      const MeshFile::Element &element = all.elements[c];
      return element.shape == simplex_shape<dim> && element.nodes.size() > n_corners(element.shape);
    };
    if (cells == CellChoice::as_in_file && can_be_cut(all, chosen))
      return true;
    if (cells == CellChoice::as_in_file)
      {
        const bool are_kept = are_simplices<dim>(all, chosen);
        if (are_kept && !are_second_order(chosen.front()))
          notes.push_back(
            "the " + simplices +
            " of first order get Degree = 1 unless the scene sets it, and are too stiff then, in "
            "bending and where Poisson's ratio is above 0.4 (locking): set Degree = 2");
        return are_kept;
      }
    const bool are_all_simplices = std::all_of(chosen.begin(), chosen.end(), are_second_order);
    if (cells == CellChoice::hypercubes || !mid_side_nodes ||
        (!are_all_simplices && !can_be_cut(all, chosen)))
      return false;
    const std::string they = are_all_simplices ? simplices : "cells";
    notes.push_back(needs_hypercubes.empty() ?
                      "the " + they + " of second order " +
                        (are_all_simplices ? "are kept" : "become " + simplices) +
                        "; Cells = " + hypercubes + " divides them" :
                      "the " + they + " of second order are divided, as " + needs_hypercubes +
                        " needs " + hypercubes);
    return needs_hypercubes.empty();
  }



  // Nodes that coincide must be merged before cells are divided, so that neighbours agree.
  template <int dim>
  FileSelection
  FileMesh<dim>::divide(MeshFile                 &all,
                        const std::string        &needs_hypercubes,
                        std::vector<std::string> &notes) const
  {
    FileSelection                   result = selection;
    const std::vector<unsigned int> chosen = cells_of_part(all, dim, selection.part);
    recognise_collapsed_cells(all, chosen);
    const bool are_kept = keeps_simplices(all, chosen, needs_hypercubes, notes);
    if (!are_kept && !ChosenCells(all, dim, selection.part).any)
      return result;
    if (selection.coinciding_nodes == CoincidingPoints::merge)
      {
        merge_coinciding_nodes(all, dim, selection.part, selection.node_distance);
        result.coinciding_nodes = CoincidingPoints::refuse;
        result.node_distance    = 0;
      }
    const bool are_simplices = std::all_of(chosen.begin(), chosen.end(), [&](const unsigned int c) {
      return all.elements[c].shape == simplex_shape<dim>;
    });
    append(!are_kept     ? divide_cells(all, dim, selection.part, mid_side_nodes) :
           are_simplices ? check_simplices(all, chosen, dim) :
                           cut_into_simplices(all, dim, chosen, mid_side_nodes),
           notes);
    return result;
  }



  // The steps depend on each other: (1) read; (2) sets of the scene; (3) division into hexahedra;
  // (4) the part as a triangulation; (5) curved boundaries of the scene; (6) mid-side nodes, or
  // else reconstruction of surfaces. `key` is the key of the scene that an error refers to.
  template <int dim>
  std::vector<std::string>
  FileMesh<dim>::read_file(const std::string &folder, const std::string &needs_hypercubes)
  {
    const std::string path = find_beside_scene(file, folder);
    if (file_exists(path))
      file = std::filesystem::absolute(path).lexically_normal(); // for the scene that is written
    std::vector<std::string> notes;
    std::string              key = "File";
    try
      {
        // Step 1: the file. `key` is updated before each step that may throw.
        // Only a plane model rotates the mesh: cells of a solid have no plane.
        MeshFile all = read_mesh_file(path);
        if (dim == 2)
          append(flatten(all), notes);
        add_pieces(all, dim);

        key                                  = "Part";
        const std::vector<std::string> parts = part_names(all, dim);
        if (!selection.part.empty() && !is_in(selection.part, parts))
          throw SceneError("has no such part; it has " + (parts.empty() ? "none" : join(parts)));

        for (const std::string &part : neighbours_of(all, dim, selection.part))
          my_neighbours.push_back(origin_of(part));
        add_sets(all, key);

        key = "Boundaries";
        check_groups(all, selection.boundaries);

        key                       = cells == CellChoice::as_in_file ? "Cells" : "File";
        const FileSelection after = divide(all, needs_hypercubes, notes);
        const FilePart<dim> part(all, after);
        append(part.notes, notes);
        key   = "File";
        nodes = part.nodes;
        if (part.cells[0].vertices.size() == dim + 1)
          order_of_simplices = part.elements[0]->nodes.size() > dim + 1 ? 2 : 1;
        sets_of_cells = cell_sets_of(all, part);
        if (!part.touching_pieces.empty())
          unless_pair = place_of["File"] + ": mesh file '" + path + "' " + part.touching_pieces;

        key          = "Temperature field";
        temperatures = temperatures_of(all, part, temperature_field);

        key = "Curved boundaries";
        for (const auto &surface : surfaces)
          if (!is_in(surface.name, part.boundaries))
            throw SceneError("has no boundary '" + surface.name + "'; it has " +
                             join(part.boundaries));
        Triangulation<dim> triangulation;
        triangulation.create_triangulation(part.vertices, part.cells, part.faces);
        // A face may have several names, so that a boundary of the scene consists of all ids whose
        // names contain it.
        for (unsigned int i = 0; i < surfaces.size(); ++i)
          {
            const auto &names = part.boundaries;
            const auto  name  = std::find(names.begin(), names.end(), surfaces[i].name);
            std::set<types::boundary_id> ids;
            for (types::boundary_id id = 0; id < part.names_of_ids.size(); ++id)
              for (const unsigned int one : part.names_of_ids[id])
                if (one == name - names.begin())
                  ids.insert(id);
            surfaces[i].apply(triangulation, ids, i, part.inserted);
          }

        key = "File";
        // Surfaces are reconstructed from the facets only if there are neither mid-side nodes nor
        // surfaces of the scene.
        const unsigned int n_curved =
          mid_side_nodes ? curve_cells(triangulation, all, part.elements, surfaces.size()) : 0;
        const SurfaceReconstruction rounding =
          n_curved == 0 && surfaces.empty() ?
            reconstruct_surfaces(triangulation, part, curved_text == "automatic") :
            SurfaceReconstruction();
        append(rounding.notes, notes);
        is_curved = n_curved + surfaces.size() > 0 || rounding.is_curved;
        key       = "Curved boundaries";
        check_not_folded(triangulation, part);
        mesh =
          CoarseMesh<dim>::from_triangulation(triangulation, part.boundaries, part.names_of_ids);
        mesh.facets = rounding.facets;
      }
    catch (const SceneError &error)
      {
        // The readers name the file in their messages, which may be an included one.
        const std::string what = error.what(), named = "mesh file '";
        const bool        is_it = what.compare(0, named.size(), named) == 0;
        throw SceneError(place_of[key] + ": " + (is_it ? what : named + path + "' " + what));
      }
    for (std::string &note : notes)
      note = "mesh file '" + path + "': " + note;
    return notes;
  }



  template class FileMesh<2>;
  template class FileMesh<3>;
} // namespace Signorini
