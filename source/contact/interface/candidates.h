// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/interface/surface.h"
#include "contact/search/boundary_faces.h"

#include <vector>

namespace Signorini
{
  /// Drop points of negligible weight: segments that only share a line with a face have no area.
  template <int dim>
  void
  drop_empty_points(const std::vector<FacePatch<dim>> &slave,
                    std::vector<PairedPoint<dim>>     &points);

  /// Keep the points of candidate faces, those with a point whose gap is at most `candidate_gap`
  /// (so penetrating ones in any case), and drop all others.
  template <int dim>
  void
  keep_candidates(double                          candidate_gap,
                  const BoundaryFaces<dim>       &slave,
                  std::vector<PairedPoint<dim>>  &paired,
                  std::vector<ContactPoint<dim>> &points);

  /// For pairs without separation: keep the points that touch in the reference configuration up to
  /// the discretisation error of the mesh, or that are within the search distance of the pair.
  /// Positive gaps stay as they are, penetrations are set to zero.
  template <int dim>
  void
  keep_zero_gap_points(const ContactPair<dim>         &pair,
                       const BoundaryFaces<dim>       &slave,
                       std::vector<PairedPoint<dim>>  &paired,
                       std::vector<ContactPoint<dim>> &points);
} // namespace Signorini
