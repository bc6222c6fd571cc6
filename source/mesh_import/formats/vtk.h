// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/mesh_file.h"

namespace Signorini
{
  /// Read a legacy file of VTK with an unstructured grid, as text or binary, of version 2 to 5. The
  /// groups are those of add_vtk_groups(). Throws SceneError with the name of the file.
  /// @param file_name path of the file
  /// @return the mesh
  MeshFile
  read_vtk(const std::string &file_name);
} // namespace Signorini
