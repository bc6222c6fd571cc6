// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/interface/surface.h"
#include "contact/search/boundary_faces.h"

#include <vector>

namespace Signorini
{
  /// Segments that touch a face in a line only have no area, and their points no say.
  template <int dim>
  void
  drop_empty_points(const std::vector<FacePatch<dim>> &slave,
                    std::vector<PairedPoint<dim>>     &points);

  /// Faces that are farther away than the reach are no candidates; overlapping ones always are.
  template <int dim>
  void
  keep_candidates(double                          candidate_gap,
                  const BoundaryFaces<dim>       &slave,
                  std::vector<PairedPoint<dim>>  &paired,
                  std::vector<ContactPoint<dim>> &points);

  /// Of surfaces that are never to separate, what touches at the start up to the error of the
  /// mesh, or what is within the search distance. Their gaps stay, their overlaps do not.
  template <int dim>
  void
  keep_zero_gap_points(const ContactPair<dim>         &pair,
                       const BoundaryFaces<dim>       &slave,
                       std::vector<PairedPoint<dim>>  &paired,
                       std::vector<ContactPoint<dim>> &points);
} // namespace Signorini
