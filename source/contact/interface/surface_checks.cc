// SPDX-License-Identifier: Apache-2.0
// What a surface must satisfy.
#include "base/solver_failure.h"
#include "contact/interface/surface_steps.h"
#include <signorini/base/scene_error.h>
#include <signorini/base/text.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  void
  check_gaps(const ContactPair<dim>               &pair,
             const std::vector<ContactPoint<dim>> &points,
             const MPI_Comm                        comm)
  {
    const bool bad = std::any_of(points.begin(), points.end(), [](const auto &point) {
      return !std::isfinite(point.gap);
    });
    if (Utilities::MPI::max(bad ? 1 : 0, comm) > 0)
      throw SceneError(pair.slave_location + ": Initial gap = " + pair.initial_gap.text +
                       " is not a finite number at some points of '" + pair.slave +
                       "'; correct the formula");
  }



  template <int dim>
  void
  check_stresses(const std::vector<ContactPoint<dim>> &points, const MPI_Comm comm)
  {
    const bool bad = std::any_of(points.begin(), points.end(), [](const auto &point) {
      return !point.stress.empty() && std::isnan(point.stress[0].offset);
    });
    if (Utilities::MPI::max(bad ? 1 : 0, comm) > 0)
      throw SolverFailure("cells at a contact surface are inverted; use smaller load steps");
  }



  template <int dim>
  void
  check_search_distance(const double overlap, const ContactPair<dim> &pair)
  {
    if (pair.search_distance > 0 && overlap > pair.search_distance)
      throw SceneError(pair.slave_location + ": '" + pair.slave + "' lies up to " +
                       short_text(overlap, 4) + " deep in '" + pair.master +
                       "' at the start, deeper than its Search distance of " +
                       short_text(pair.search_distance, 4) +
                       "; set a larger Search distance, or move the bodies apart");
  }



  template <int dim>
  void
  check_obstacle(const Configuration<dim> &configuration,
                 const ContactPair<dim>   &pair,
                 const Obstacle<dim>      &obstacle,
                 const BoundaryFaces<dim> &slave)
  {
    if (configuration.is_reference() || obstacle.shape->is_attached())
      return;
    const double length = configuration.elasticity().rotation_length_scale();
    const bool   bad =
      std::any_of(slave.rest.begin(), slave.rest.end(), [&](const FacePatch<dim> &face) {
        return !obstacle.shape->has_closest_point(face.center(), length);
      });
    if (Utilities::MPI::max(bad ? 1 : 0, configuration.elasticity().mesh().communicator()) > 0)
      throw SceneError(
        pair.master_location + ": the Gap of '" + obstacle.name +
        "' does not increase by 1 per unit length along its Normal, so that it defines the gap on "
        "the undeformed surface only; use a formula that is valid at all points, such as y - "
        "x^2/20 for Normal = 0, 1, or set Contact method/Contact geometry = reference");
  }



#define INSTANTIATE(dim)                                                                           \
  template void check_gaps(const ContactPair<dim> &,                                               \
                           const std::vector<ContactPoint<dim>> &,                                 \
                           const MPI_Comm);                                                        \
  template void check_stresses(const std::vector<ContactPoint<dim>> &, const MPI_Comm);            \
  template void check_search_distance(const double, const ContactPair<dim> &);                     \
  template void check_obstacle(const Configuration<dim> &,                                         \
                               const ContactPair<dim> &,                                           \
                               const Obstacle<dim> &,                                              \
                               const BoundaryFaces<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
