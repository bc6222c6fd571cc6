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

  /// Read a legacy file of VTK with an unstructured grid, as text or binary, of version 2 to 5. The
  /// groups are those of add_vtk_groups(). Throws SceneError with the name of the file.
  /// @param file_name path of the file
  /// @return the mesh
  MeshFile
  read_vtk(const std::string &file_name);

  /// Read an XML file of VTK with an unstructured grid in one piece: as text, in base64 within the
  /// arrays, or raw at the end of the file, compressed by zlib or not. The groups are those of
  /// add_vtk_groups(). Throws SceneError with the name of the file.
  /// @param file_name path of the file
  /// @return the mesh
  MeshFile
  read_vtu(const std::string &file_name);
} // namespace Signorini
