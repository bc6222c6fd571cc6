// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/mesh_file.h"

#include <set>
#include <string>
#include <vector>

namespace Signorini
{
  /// Creates the sets of nodes, faces and elements that a scene defines by their numbers in a mesh
  /// file:
  ///
  ///     NAME: 1, 4-7; OTHER NAME: 9
  ///
  /// All functions throw SceneError for texts of another form, for numbers that do not exist, and
  /// for names that the file has already.
  class NumberedSets
  {
  public:
    /// @param file the mesh file, whose names are taken
    /// @param cells indices of the elements to which numbers refer: those of the body
    NumberedSets(const MeshFile &file, const std::vector<unsigned int> &cells);

    /// Add sets of nodes.
    /// @param text items NUMBER, FIRST-LAST, INSTANCE.NUMBER, INSTANCE.FIRST-LAST
    /// @param file to whose groups the sets are added
    void
    add_nodes(const std::string &text, MeshFile &file) const;

    /// Add sets of faces of elements, with the labels of Abaqus.
    /// @param text items NUMBER.LABEL, FIRST-LAST.LABEL
    /// @param file to whose groups the sets are added
    void
    add_faces(const std::string &text, MeshFile &file) const;

    /// Add sets of elements.
    /// @param text items NUMBER, FIRST-LAST
    /// @param file to whose groups the sets are added
    void
    add_cells(const std::string &text, MeshFile &file) const;

  private:
    using Numbers = std::unordered_map<std::size_t, unsigned int>;

    std::set<std::string> names; ///< that the file has
    Numbers               elements;
  };
} // namespace Signorini
