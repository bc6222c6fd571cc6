// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/curved_face.h"
#include "mesh_import/reconstruction/facet_graph.h"

namespace Signorini
{
  /// A facet that is replaced by a part of a smooth surface.
  template <int dim>
  struct SmoothFace
  {
    unsigned int face; ///< index into the list of faces
    /// The curved edges, from which CurvedFace interpolates the surface.
    typename CurvedFace<dim>::Edges edges;
    /// Estimated distance [length] of the curved face from the true surface.
    double uncertainty;
  };

  /// The result of find_smooth_faces().
  template <int dim>
  struct SmoothFaces
  {
    /// The facets that become curved.
    std::vector<SmoothFace<dim>> faces;
    /// All vertices of the mesh; those that were inserted by dividing cells have been moved onto
    /// the reconstructed surface.
    std::vector<dealii::Point<dim>> vertices;
  };

  /// Reconstruct facets whose corners are on any smooth surface, such as a spline. At each corner a
  /// polynomial of third (or second) degree is fitted to the corners around. It determines the
  /// normal where its deviation from them is at most a quarter of the sagitta of the facets. Edges
  /// become cubic curves with the tangents that follow from these normals, so that the distance
  /// from the surface is of order four in the mesh size (in the middle of faces that are far from
  /// parallelograms, a hundredth of the sagitta). Kinks and jumps of the curvature cannot be
  /// fitted: the facets near them are kept.
  /// @param graph the boundary faces with their neighbours
  /// @param known for each face whether its surface is known already; such faces are not changed
  /// @return the curved faces and the moved vertices
  template <int dim>
  SmoothFaces<dim>
  find_smooth_faces(const FacetGraph<dim> &graph, const std::vector<bool> &known);
} // namespace Signorini
