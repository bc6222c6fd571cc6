// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/mesh_file.h"

namespace Signorini
{
  /// Read an XML file of VTK with an unstructured grid, as text, in base64 within the arrays, or
  /// raw behind them, compressed by zlib or not. Groups: see add_vtk_groups(). Throws SceneError
  /// with the name of the file.
  MeshFile
  read_vtu(const std::string &file_name);
} // namespace Signorini
