// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/mesh_file.h"

namespace Signorini
{
  /// Read an ASCII mesh file of Gmsh (format 2.2 or 4.1). The groups are the physical names, in the
  /// order of dimensions and tags, followed in each dimension by groups without name, which are
  /// called by their tag. Throws SceneError with the name of the file if it is not such a file.
  /// @param file_name path of the file
  /// @return the mesh
  MeshFile
  read_gmsh(const std::string &file_name);
} // namespace Signorini
