// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/mesh_file.h"

namespace Signorini
{
  /// The elements of that dimension, of one group or of all if `part` is empty.
  std::vector<unsigned int>
  cells_of_part(const MeshFile &file, unsigned int dim, const std::string &part);

  /// Which elements of a mesh file are to be divided.
  struct ChosenCells
  {
    std::vector<bool> all;           ///< by element
    std::vector<bool> as_tetrahedra; ///< those that become tetrahedra first
    bool              any = false;

    /// @param part the group whose cells are looked at; empty: all cells
    ChosenCells(const MeshFile &file, unsigned int dim, const std::string &part);
  };
} // namespace Signorini
