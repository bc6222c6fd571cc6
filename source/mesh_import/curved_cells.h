// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/mesh_file.h"

#include <deal.II/grid/tria.h>

namespace Signorini
{
  /// Give cells of second order the shape of their mid-side nodes. Each cell that is not straight
  /// gets a manifold of its own, which its faces and lines share unless a neighbour came first:
  /// both agree on the common nodes. Throws SceneError with the element if a curved cell is folded.
  /// @param triangulation a coarse mesh whose cells correspond to the elements
  /// @param file the mesh file with the nodes
  /// @param elements the element of each cell of the triangulation
  /// @param first manifold id; the others follow
  /// @return the number of curved cells, i.e. of manifold ids that were used
  template <int dim>
  unsigned int
  curve_cells(dealii::Triangulation<dim>                   &triangulation,
              const MeshFile                               &file,
              const std::vector<const MeshFile::Element *> &elements,
              dealii::types::manifold_id                    first);
} // namespace Signorini
