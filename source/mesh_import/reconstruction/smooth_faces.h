// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/curved_face.h"
#include "mesh_import/reconstruction/facet_graph.h"

namespace Signorini
{
  /// A facet as part of a smooth surface.
  template <int dim>
  struct SmoothFace
  {
    unsigned int                    face; ///< index into the list of faces
    typename CurvedFace<dim>::Edges edges;
    double uncertainty; ///< how far the surface may be from the true one, about
  };

  /// What is smooth among facets.
  template <int dim>
  struct SmoothFaces
  {
    std::vector<SmoothFace<dim>>    faces;
    std::vector<dealii::Point<dim>> vertices; ///< of the mesh, those made on the surface
  };

  /// Facets with their corners on any smooth surface, such as splines are. At each corner a
  /// polynomial of third (or second) degree is fitted to those around; where it is as near to them
  /// as a quarter of the facets' sagitta, it gives the normal. Edges are cubic curves with the
  /// tangents that follow, so that the distance from the surface is of order four (in the middle of
  /// faces that are far from parallelograms, a hundredth of the sagitta). Kinks and jumps of the
  /// curvature do not fit: facets stay facets near them.
  /// @param known faces whose surface is known, which stay as they are
  template <int dim>
  SmoothFaces<dim>
  find_smooth_faces(const FacetGraph<dim> &graph, const std::vector<bool> &known);
} // namespace Signorini
