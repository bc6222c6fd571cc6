// SPDX-License-Identifier: Apache-2.0
#include "contact/interface/surface_steps.h"

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  void
  drop_empty_points(const std::vector<FacePatch<dim>> &slave, std::vector<PairedPoint<dim>> &points)
  {
    // Relative to the Jacobian at the point: a share of less than 1e-13 of the face is rounding.
    const auto is_empty = [&](const PairedPoint<dim> &point) {
      return point.weight < 1e-13 * slave[point.face].jacobian(point.xi);
    };
    points.erase(std::remove_if(points.begin(), points.end(), is_empty), points.end());
  }



  template <int dim>
  void
  keep_candidates(const double                    candidate_gap,
                  const BoundaryFaces<dim>       &slave,
                  std::vector<PairedPoint<dim>>  &paired,
                  std::vector<ContactPoint<dim>> &points)
  {
    // Faces take part as a whole, as soon as one point is near.
    std::vector<bool> is_near(slave.faces.size(), false);
    for (const ContactPoint<dim> &point : points)
      if (point.current_gap() <= candidate_gap)
        is_near[point.face] = true;
    const auto is_far = [&](const auto &point) { return !is_near[point.face]; };
    paired.erase(std::remove_if(paired.begin(), paired.end(), is_far), paired.end());
    points.erase(std::remove_if(points.begin(), points.end(), is_far), points.end());
  }



  template <int dim>
  void
  keep_zero_gap_points(const ContactPair<dim>         &pair,
                       const BoundaryFaces<dim>       &slave,
                       std::vector<PairedPoint<dim>>  &paired,
                       std::vector<ContactPoint<dim>> &points)
  {
    constexpr double error_of_mesh = 0.1;
    const bool       is_given      = pair.gap_is_given();
    unsigned int     n             = 0;
    for (unsigned int i = 0; i < points.size(); ++i)
      {
        // Points that do not touch up to a tenth of a face, the error of meshes of curved surfaces,
        // are dropped, unless a search distance or a given gap selects them.
        // Gaps that are kept would hide that surfaces do not fit, whatever their sign.
        const double most = error_of_mesh * slave.patches[points[i].face].diameter(),
                     gap  = pair.keeps_gaps ? std::abs(points[i].gap) : points[i].gap;
        if (!is_given && pair.search_distance == 0 && gap > most)
          continue;
        if (pair.keeps_gaps)
          points[i].prescribed_gap = -points[i].gap;
        if (!is_given)
          points[i].gap = pair.keeps_gaps ? 0. :
                          pair.is_tied    ? points[i].gap :
                                            std::min(points[i].gap, 0.);
        if (n < i)
          {
            points[n] = std::move(points[i]);
            paired[n] = std::move(paired[i]);
          }
        ++n;
      }
    points.resize(n);
    paired.resize(n);
  }



#define INSTANTIATE(dim)                                                                           \
  template void drop_empty_points(const std::vector<FacePatch<dim>> &,                             \
                                  std::vector<PairedPoint<dim>> &);                                \
  template void keep_candidates(double,                                                            \
                                const BoundaryFaces<dim> &,                                        \
                                std::vector<PairedPoint<dim>> &,                                   \
                                std::vector<ContactPoint<dim>> &);                                 \
  template void keep_zero_gap_points(const ContactPair<dim> &,                                     \
                                     const BoundaryFaces<dim> &,                                   \
                                     std::vector<PairedPoint<dim>> &,                              \
                                     std::vector<ContactPoint<dim>> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
