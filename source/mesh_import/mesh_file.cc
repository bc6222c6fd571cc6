// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/mesh_file.h"

#include "mesh_import/formats/abaqus.h"
#include "mesh_import/formats/readers.h"
#include <signorini/base/text.h>
#include <signorini/parameters/raw.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace Signorini
{
  namespace
  {
    /// A file format, with the function that reads it. New formats are added to the registry below.
    struct Format
    {
      std::string extension, name;
      MeshFile (*read)(const std::string &file_name);
    };

    // The registry: one line a format.
    const std::vector<Format> registry = {{".msh", "Gmsh", read_gmsh},
                                          {".inp", "Abaqus and CalculiX", read_abaqus},
                                          {".vtk", "VTK", read_vtk},
                                          {".vtu", "VTK", read_vtu}};



    /// Dimension and number of corners of a shape.
    struct ShapeFacts
    {
      unsigned int dimension, n_corners;
    };

    /// @return the entry of the table, in the order of MeshFile::Shape.
    ShapeFacts
    facts(const MeshFile::Shape shape)
    {
      static const std::array<ShapeFacts, 9> table{
        {{0, 1}, {1, 2}, {2, 3}, {2, 4}, {3, 4}, {3, 5}, {3, 6}, {3, 8}, {4, 0}}};
      return table[static_cast<unsigned int>(shape)];
    }



    /// Throws SceneError if a coordinate is not finite. Binary files may contain any bit pattern;
    /// text is checked while it is read.
    void
    check_finite(const MeshFile &file, const std::string &file_name)
    {
      for (std::size_t i = 0; i < file.nodes.size(); ++i)
        for (unsigned int d = 0; d < 3; ++d)
          if (!std::isfinite(file.nodes[i][d]))
            throw SceneError("mesh file '" + file_name + "' has point " + std::to_string(i) +
                             ", counted from 0, whose " + "xyz"[d] + " is no finite number");
    }
  } // namespace



  MeshFile::Group &
  MeshFile::group(const std::string &name)
  {
    const auto found =
      std::find_if(groups.begin(), groups.end(), [&](const Group &g) { return g.name == name; });
    if (found != groups.end())
      return *found;
    groups.push_back({name, {}, {}, {}});
    return groups.back();
  }



  const MeshFile::Nodes &
  MeshFile::parent_face(const Nodes &corners) const
  {
    if (whole_faces.empty())
      return corners;
    Nodes key = corners;
    std::sort(key.begin(), key.end());
    const auto found = whole_faces.find(key);
    return found == whole_faces.end() ? corners : found->second;
  }



  unsigned int
  dimension_of(const MeshFile::Shape shape)
  {
    return facts(shape).dimension;
  }



  unsigned int
  n_corners(const MeshFile::Shape shape)
  {
    return facts(shape).n_corners;
  }



  MeshFile::Nodes
  corners_of(const MeshFile::Element &element)
  {
    if (element.shape == MeshFile::Shape::unknown)
      return element.nodes;
    return {element.nodes.begin(), element.nodes.begin() + n_corners(element.shape)};
  }



  std::vector<std::string>
  part_names(const MeshFile &file, const unsigned int dim)
  {
    std::vector<std::string> names;
    for (const auto &group : file.groups)
      if (std::any_of(group.elements.begin(), group.elements.end(), [&](const unsigned int e) {
            return dimension_of(file.elements[e].shape) == dim;
          }))
        names.push_back(group.name);
    return names;
  }



  // The extension, in any case, selects the reader.
  MeshFile
  read_mesh_file(const std::string &file_name)
  {
    std::string extension = std::filesystem::path(file_name).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(), ::tolower);
    for (const Format &format : registry)
      if (format.extension == extension)
        {
          if (is_directory(file_name))
            throw SceneError("mesh file '" + file_name + "' is a directory");
          if (!std::ifstream(file_name))
            throw SceneError("mesh file '" + file_name + "' cannot be opened");
          MeshFile file = format.read(file_name);
          check_finite(file, file_name);
          return file;
        }
    throw SceneError("mesh file '" + file_name + "' has the unknown extension '" + extension +
                     "'; there are " + mesh_formats() +
                     "; most others become one of them by: meshio convert FILE mesh.vtu");
  }



  std::string
  mesh_formats()
  {
    std::vector<std::string> words;
    for (const Format &format : registry)
      words.push_back(format.extension + " (" + format.name + ")");
    return join(words);
  }
} // namespace Signorini
