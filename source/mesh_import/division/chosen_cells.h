// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/mesh_file.h"

namespace Signorini
{
  /// @return indices of the elements of dimension `dim` in a group, in ascending order.
  /// @param file the mesh
  /// @param dim 2 or 3
  /// @param part name of the group; empty: all elements
  std::vector<unsigned int>
  cells_of_part(const MeshFile &file, unsigned int dim, const std::string &part);

  /// The elements of a mesh file that have to be divided so that only quadrilaterals or hexahedra
  /// are left.
  struct ChosenCells
  {
    /// For each element of the file whether it is divided.
    std::vector<bool> all;
    /// For each element of the file whether it is divided into triangles or tetrahedra first.
    std::vector<bool> as_simplices;
    /// Whether any element is not a quadrilateral or hexahedron, i.e. whether anything has to be
    /// done.
    bool any = false;

    /// Choose the elements.
    /// @param file the mesh
    /// @param dim 2 or 3
    /// @param part the group whose cells are considered; empty: all cells
    ChosenCells(const MeshFile &file, unsigned int dim, const std::string &part);

    /// Choose all of some elements, to be divided into triangles or tetrahedra.
    ChosenCells(const MeshFile &file, const std::vector<unsigned int> &cells);
  };
} // namespace Signorini
