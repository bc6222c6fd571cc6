// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/file_part.h"
#include <signorini/geometry/coarse_mesh.h>

#include <deal.II/grid/tria.h>

namespace Signorini
{
  struct SurfaceReconstruction
  {
    std::vector<std::string> notes;  ///< a line for each surface that was recognised
    std::vector<FacetHeight> facets; ///< CoarseMesh::facets
  };

  /// Recognise round surfaces in the boundary of a mesh from a file, see find_round_faces().
  /// @param triangulation of the part; faces get manifolds, and vertices between others are moved
  /// @param automatic no: facets stay facets
  template <int dim>
  SurfaceReconstruction
  reconstruct_surfaces(dealii::Triangulation<dim> &triangulation,
                       const FilePart<dim>        &part,
                       bool                        automatic);
} // namespace Signorini
