// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/mesh_file.h"

namespace Signorini
{
  /// Make one node of those that coincide, in elements and groups. Cells that are to be divided
  /// must be connected before: otherwise neighbours that meet at nodes of their own may be divided
  /// differently.
  /// @param part the group whose cells' nodes these are; empty: all cells of that dimension
  /// @param distance up to which nodes coincide; 0: 1e-3 of the shortest edge
  void
  merge_coinciding_nodes(MeshFile          &file,
                         unsigned int       dim,
                         const std::string &part,
                         double             distance);
} // namespace Signorini
