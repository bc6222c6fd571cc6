// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/curved_boundary.h"
#include "mesh_import/file_part.h"
#include <signorini/mesh/generator.h>

namespace Signorini
{
  /// @return whether a file exists; false also for names that no file can have.
  /// @param name path
  bool
  file_exists(const std::string &name);

  /// @return the path of a file: as named, or in a folder; the name itself if it is in neither.
  /// @param file name
  /// @param folder in which it is looked for if it is not found as named
  std::string
  find_beside_scene(const std::string &file, const std::string &folder);

  /// What becomes of cells that are not quadrilaterals or hexahedra: they are divided into these;
  /// or kept; or kept if they are simplices of second order and nothing in the scene needs others.
  enum class CellChoice
  {
    hypercubes,
    as_in_file,
    automatic
  };

  /// A mesh file, or one part of it. Boundaries: the names that the file gives to faces of the
  /// part, and `unnamed`, or `unnamed1` and so on, for faces without.
  template <int dim>
  class FileMesh : public MeshGenerator<dim>
  {
  public:
    void
    declare(Section &section) override;

    /// Read and check the file. Throws SceneError if its mesh cannot be used, or names of the scene
    /// are not in it.
    std::vector<std::string>
    read_file(const std::string &folder, const std::string &needs_hypercubes) override;

    std::vector<std::string>
    boundaries() const override
    {
      return mesh.boundaries;
    }

    CoarseMesh<dim>
    generate() const override
    {
      return mesh;
    }

    bool
    has_temperature() const override
    {
      return !temperature_field.empty();
    }

    const std::vector<double> &
    temperature() const override
    {
      return temperatures;
    }

    bool
    curved() const override
    {
      return is_curved;
    }

    bool
    has_simplices() const override
    {
      return order_of_simplices > 0;
    }

    unsigned int
    degree_of_elements() const override
    {
      return order_of_simplices;
    }

    std::vector<std::string>
    node_sets() const override
    {
      return nodes.names();
    }

    NodeSet<dim>
    node_set(const std::string &name) const override
    {
      return nodes.find(name);
    }

    std::vector<std::string>
    cell_sets() const override
    {
      std::vector<std::string> names;
      for (const auto &[name, cells] : sets_of_cells)
        names.push_back(name);
      return names;
    }

    std::vector<unsigned int>
    cell_set(const std::string &name) const override
    {
      const auto found = sets_of_cells.find(name);
      return found == sets_of_cells.end() ? std::vector<unsigned int>() : found->second;
    }

    std::string
    needs_pair() const override
    {
      return unless_pair;
    }

    std::string
    origin() const override
    {
      return selection.part.empty() ? "" : origin_of(selection.part);
    }

    std::vector<std::string>
    neighbours() const override
    {
      return my_neighbours;
    }

  private:
    /// @return the origin of cells of a part.
    std::string
    origin_of(const std::string &part) const
    {
      return "part '" + part + "' of mesh file '" + file + "'";
    }

    /// Add the sets that the scene defines as if they were in the file.
    /// @param all the file
    /// @param key is set to the key that is processed, for messages
    void
    add_sets(MeshFile &all, std::string &key) const;

    /// @return whether the cells are triangles or tetrahedra that are kept. Throws SceneError if
    /// all cells are to be kept, but cannot.
    /// @param all the file
    /// @param chosen numbers of the cells of the body
    /// @param needs_hypercubes see read_file()
    /// @param notes to which messages are appended
    bool
    keeps_simplices(const MeshFile                  &all,
                    const std::vector<unsigned int> &chosen,
                    const std::string               &needs_hypercubes,
                    std::vector<std::string>        &notes) const;

    /// Divide cells that are not quadrilaterals or hexahedra, unless they are kept.
    /// @param all the file, which is changed
    /// @param needs_hypercubes see read_file()
    /// @param notes to which messages are appended
    /// @return the selection for the divided file
    FileSelection
    divide(MeshFile                 &all,
           const std::string        &needs_hypercubes,
           std::vector<std::string> &notes) const;

    std::string   file, curved_text = "automatic", temperature_field;
    std::string   node_set_text, face_set_text, cell_set_text;
    FileSelection selection;
    CellChoice    cells          = CellChoice::automatic;
    bool          mid_side_nodes = true;
    /// The order of the elements if they are simplices, otherwise 0.
    unsigned int order_of_simplices = 0;
    /// The surfaces that `curved_text` describes.
    std::vector<CurvedBoundary<dim>> surfaces;
    /// Positions of keys in the scene.
    std::map<std::string, std::string> place_of;

    CoarseMesh<dim> mesh;
    /// Temperatures at the vertices of the mesh.
    std::vector<double>                              temperatures;
    FileNodes<dim>                                   nodes;
    std::map<std::string, std::vector<unsigned int>> sets_of_cells;
    std::string                                      unless_pair;
    std::vector<std::string>                         my_neighbours;
    bool                                             is_curved = false;
  };
} // namespace Signorini
