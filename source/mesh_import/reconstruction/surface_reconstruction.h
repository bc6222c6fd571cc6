// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/file_part.h"
#include <signorini/geometry/coarse_mesh.h>

#include <deal.II/grid/tria.h>

namespace Signorini
{
  /// The result of reconstruct_surfaces().
  struct SurfaceReconstruction
  {
    /// One message for each surface that was reconstructed, and for each that stays flat although
    /// it may be meant as curved.
    std::vector<std::string> notes;
    /// Whether any surface was reconstructed.
    bool is_curved = false;
    /// The steepest facet of each boundary, for CoarseMesh::facets.
    std::vector<FacetHeight> facets;
  };

  /// Replace facets of the boundary of a mesh from a file by curved surfaces: circles, spheres,
  /// cylinders and cones (see find_round_faces()) and other smooth surfaces (see
  /// find_smooth_faces()). Every process has the whole coarse mesh and computes the same; nothing
  /// is communicated.
  /// @param triangulation of the part, whose faces get manifolds; vertices that were inserted by
  /// dividing cells are moved
  /// @param part the part of the file, whose faces and vertices have the numbers of the
  /// triangulation
  /// @param automatic false: the facets are kept, and only measured
  /// @return messages for the user, and the steepest facet of each boundary
  template <int dim>
  SurfaceReconstruction
  reconstruct_surfaces(dealii::Triangulation<dim> &triangulation,
                       const FilePart<dim>        &part,
                       bool                        automatic);
} // namespace Signorini
