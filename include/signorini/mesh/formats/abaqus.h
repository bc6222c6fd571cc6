#pragma once

#include <signorini/mesh/mesh_file.h>

namespace Signorini
{
  /// Read an input file of Abaqus or CalculiX, without parts and instances. Groups: element sets
  /// (the elements), element surfaces (the faces; without a face label all faces of the elements),
  /// node sets and node surfaces (the nodes). Materials, steps and all else are left out; the type
  /// of an element says its shape and no more. Throws SceneError with file and line if something
  /// cannot be understood, or if the file makes nodes or elements out of others.
  MeshFile
  read_abaqus(const std::string &file_name);
} // namespace Signorini
