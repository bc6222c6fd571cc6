// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/mesh_file.h"

namespace Signorini
{
  /// Merge nodes that coincide, in elements, groups and numbers. Cells that are to be divided must
  /// be connected before: otherwise neighbours that meet at nodes of their own may be divided
  /// differently.
  /// @param file the mesh, which is changed
  /// @param dim 2 or 3
  /// @param part the group whose cells' nodes are considered; empty: all cells of that dimension
  /// @param distance [length] up to which nodes coincide; 0: 1e-3 of the shortest edge
  void
  merge_coinciding_nodes(MeshFile          &file,
                         unsigned int       dim,
                         const std::string &part,
                         double             distance);
} // namespace Signorini
