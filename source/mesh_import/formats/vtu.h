// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/mesh_file.h"

namespace Signorini
{
  /// Read an XML file of VTK with an unstructured grid in one piece: as text, in base64 within the
  /// arrays, or raw at the end of the file, compressed by zlib or not. The groups are those of
  /// add_vtk_groups(). Throws SceneError with the name of the file.
  /// @param file_name path of the file
  /// @return the mesh
  MeshFile
  read_vtu(const std::string &file_name);
} // namespace Signorini
