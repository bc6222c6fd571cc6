// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/mesh_file.h"

#include <map>
#include <string>

namespace Signorini
{
  /// Cut the cells of a mesh along a plane surface inside of it, such as a section through a bolt.
  /// The nodes of the surface are doubled, except on its rim where that is inside of the mesh:
  /// cells on one side keep them, those on the other get the copies, in all groups too. The faces
  /// of the other side become a group of their own. Throws SceneError if there is no such surface,
  /// or if it is not about plane or not inside of the mesh.
  /// @param file the mesh
  /// @param surface name of a group with faces, in any case of letters
  /// @param other_side name of the new group
  /// @return the copy of each node that was doubled
  std::map<unsigned int, unsigned int>
  cut_mesh(MeshFile &file, const std::string &surface, const std::string &other_side);
} // namespace Signorini
