// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/reconstruction/facet_graph.h"
#include "mesh_import/reconstruction/fitted_surface.h"

namespace Signorini
{
  /// Facets that approximate a circle, sphere, cylinder or cone.
  template <int dim>
  struct RoundFaces
  {
    FittedSurface<dim>        surface;
    std::vector<unsigned int> faces; ///< indices into the list of faces
    /// Largest distance [length] of the facets from the surface, estimated from the angles between
    /// them.
    double sagitta;
  };

  /// The result of find_round_faces() for all boundary faces of a mesh.
  template <int dim>
  struct Facets
  {
    /// The surfaces that were recognised; no face is in two of them.
    std::vector<RoundFaces<dim>> round;
    /// For each face an estimate of its distance [length] from a smooth surface through its corners
    /// and those of the faces next to it; 0 for faces in `round`.
    std::vector<double> sagitta;
  };

  /// Recognise circles, spheres, cylinders and cones in a boundary that a CAD program or mesh
  /// generator has approximated by facets: these meet at small angles, and all their corners are on
  /// the surface. Such surfaces may continue smoothly as others, as fillets do. Regions grow from
  /// seeds of a few facets, as long as corners are on the fitted surface up to a hundredth of the
  /// sagitta of the facets.
  /// @param graph the boundary faces with their neighbours
  template <int dim>
  Facets<dim>
  find_round_faces(const FacetGraph<dim> &graph);
} // namespace Signorini
