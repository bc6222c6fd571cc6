// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/mesh_file.h"

namespace Signorini
{
  /// Read an ASCII mesh file of Gmsh (format 2.2 or 4.1). Groups: the physical names, in the order
  /// of dimensions and tags. Throws SceneError with the name of the file if it is not such a file.
  MeshFile
  read_gmsh(const std::string &file_name);
} // namespace Signorini
