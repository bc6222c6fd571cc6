// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/mesh_file.h"

namespace Signorini
{
  /// Add cells to a file whose nodes have been read. Throws SceneError, without the file's name, if
  /// points do not exist, or are not as many as the type of a cell has.
  /// @param file the mesh, which is changed
  /// @param types of the cells, as VTK numbers them
  /// @param offsets into `points`: of the first point of each cell, and the end of the last cell
  /// @param points of all cells, one cell after the other
  void
  add_vtk_cells(MeshFile                &file,
                const std::vector<long> &types,
                const std::vector<long> &offsets,
                const std::vector<long> &points);

  /// Add a group "NAME VALUE" for each value in an array of integers. An array of more than 1000
  /// values numbers the cells rather than naming sets of them, and defines no groups.
  /// @param file the mesh, which is changed
  /// @param name of the array
  /// @param values one for each cell
  void
  add_vtk_groups(MeshFile &file, const std::string &name, const std::vector<long> &values);
} // namespace Signorini
