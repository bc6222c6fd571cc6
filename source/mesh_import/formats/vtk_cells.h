// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/mesh_file.h"

namespace Signorini
{
  /// Add cells to a file whose nodes are there.
  /// @param types as VTK numbers them, one a cell
  /// @param offsets into `points`, of the first point of each cell, and the end of the last cell
  /// Throws SceneError, without the file's name, if the points are not there or not as many as a
  /// type has.
  void
  add_vtk_cells(MeshFile                &file,
                const std::vector<long> &types,
                const std::vector<long> &offsets,
                const std::vector<long> &points);

  /// Add the groups of an array of integers, one a cell: "NAME VALUE" for each value. An array of
  /// more than 1000 values counts the cells rather than naming them, and gives no groups.
  void
  add_vtk_groups(MeshFile &file, const std::string &name, const std::vector<long> &values);
} // namespace Signorini
