// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/obstacles/triangle_surface.h"

namespace Signorini
{
  /// Read an STL file, as text or binary. Vertices at equal positions are merged. The normals in
  /// the file are ignored: the order of the vertices determines the outer side. Throws SceneError
  /// with the name of the file.
  Triangles
  read_stl(const std::string &file_name);
} // namespace Signorini
