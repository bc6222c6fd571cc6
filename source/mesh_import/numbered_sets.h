// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/mesh_file.h"

#include <set>
#include <string>
#include <vector>

namespace Signorini
{
  /// Sets of nodes, faces and elements that a scene makes of the numbers in a mesh file:
  ///
  ///     NAME: 1, 4-7; OTHER NAME: 9
  ///
  /// All functions throw SceneError for what cannot be understood, for numbers that are not there,
  /// and for names that the file has already.
  class NumberedSets
  {
  public:
    /// @param cells indices of the elements that numbers stand for: those of the body
    NumberedSets(const MeshFile &file, const std::vector<unsigned int> &cells);

    /// Nodes: NUMBER, FIRST-LAST, INSTANCE.NUMBER, INSTANCE.FIRST-LAST.
    void
    add_nodes(const std::string &text, MeshFile &file) const;

    /// Faces of elements with the labels of Abaqus: NUMBER.LABEL, FIRST-LAST.LABEL.
    void
    add_faces(const std::string &text, MeshFile &file) const;

    /// Elements: NUMBER, FIRST-LAST.
    void
    add_cells(const std::string &text, MeshFile &file) const;

  private:
    using Numbers = std::unordered_map<std::size_t, unsigned int>;

    std::set<std::string> names; ///< that the file has
    Numbers               elements;
  };
} // namespace Signorini
