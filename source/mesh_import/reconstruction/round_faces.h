// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/reconstruction/facet_graph.h"
#include "mesh_import/reconstruction/fitted_surface.h"

namespace Signorini
{
  /// Facets that stand for a round surface.
  template <int dim>
  struct RoundFaces
  {
    FittedSurface<dim>        surface;
    std::vector<unsigned int> faces;   ///< indices into the list of faces
    double                    sagitta; ///< largest distance of facets from the surface, about
  };

  /// All faces of a list.
  template <int dim>
  struct Facets
  {
    std::vector<RoundFaces<dim>> round;
    /// Of each face that is not in there, how far a smooth surface through its corners and those of
    /// the faces next to it would be from it, about.
    std::vector<double> sagitta;
  };

  /// What CAD programs make of circles, spheres, cylinders and cones: facets that meet at small
  /// angles, with all corners on the surface. Such surfaces may go on smoothly as others, as
  /// fillets do. Found from seeds of a few facets, which grow as far as corners lie on the surface,
  /// up to a hundredth of the sagitta of the facets.
  template <int dim>
  Facets<dim>
  find_round_faces(const FacetGraph<dim> &graph);
} // namespace Signorini
