// SPDX-License-Identifier: Apache-2.0
#include "contact/interface/contact_points.h"
#include "contact/interface/surface_steps.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The gaps of slave points to a deformable master in the reference configuration [length]; NaN
    /// without a projection. Collective.
    template <int dim>
    std::vector<double>
    gaps_of_bodies(const Elasticity<dim>               &elasticity,
                   const ContactPair<dim>              &pair,
                   const BoundaryFaces<dim>            &slave,
                   const double                         limit,
                   const std::vector<PairedPoint<dim>> &paired)
    {
      const MPI_Comm           comm = elasticity.mesh().communicator();
      const BoundaryFaces<dim> master =
        BoundaryFaces<dim>::of_master(Configuration<dim>(elasticity), pair);
      std::vector<Point<dim>>     positions;
      std::vector<Tensor<1, dim>> normals;
      double                      farthest = limit;
      // Positions and normals of the reference configuration, at the same parameters of the face.
      // The radius is that of the largest face, and the same on all ranks.
      for (const PairedPoint<dim> &point : paired)
        {
          positions.push_back(slave.rest[point.face].position(point.xi));
          normals.push_back(slave.rest[point.face].normal(point.xi));
          farthest = std::max(farthest, search_radius(slave.rest[point.face], limit));
        }
      // No shape functions or stiffness are needed of the projections.
      const MasterFaces<dim> faces{master.rest,
                                   [](unsigned int, const Point<dim - 1> &, auto &) {}};
      const auto             master_points = find_master_projections(
        positions, normals, faces, Utilities::MPI::max(farthest, comm), comm);
      std::vector<double> gaps;
      for (std::size_t i = 0; i < master_points.size(); ++i)
        gaps.push_back(master_points[i] ? gap_of(positions[i], *master_points[i]) :
                                          std::numeric_limits<double>::quiet_NaN());
      return gaps;
    }
  } // namespace



  // Settings that refer to the undeformed bodies: a given gap, closed gaps, bilateral points, and
  // interference other than at once. Otherwise the gap of the displaced configuration is all that
  // counts, and the second search is saved.
  template <int dim>
  bool
  needs_reference_gaps(const ContactPair<dim> &pair)
  {
    return pair.gap_is_given() || pair.closes_below >= 0 || !pair.can_separate ||
           pair.interference.formula() != "1";
  }



  // Gaps at the points of a displaced configuration, as they were in the reference configuration.
  // Collective.
  template <int dim>
  std::vector<double>
  reference_gaps(const Elasticity<dim>         &elasticity,
                 const ContactPair<dim>        &pair,
                 const Obstacle<dim>           *obstacle,
                 const BoundaryFaces<dim>      &slave,
                 const double                   limit,
                 std::vector<PairedPoint<dim>> &paired)
  {
    std::vector<double> gaps;
    if (!obstacle)
      gaps = gaps_of_bodies(elasticity, pair, slave, limit, paired);
    else
      for (const PairedPoint<dim> &point : paired)
        gaps.push_back(obstacle->shape->closest(slave.rest[point.face].position(point.xi)).gap);
    // Drop points without a reference gap, in both lists alike.
    std::size_t n = 0;
    for (std::size_t i = 0; i < paired.size(); ++i)
      if (std::isfinite(gaps[i]))
        {
          if (n < i)
            paired[n] = std::move(paired[i]);
          gaps[n++] = gaps[i];
        }
    paired.resize(n);
    gaps.resize(n);
    return gaps;
  }



#define INSTANTIATE(dim)                                                                           \
  template bool                needs_reference_gaps(const ContactPair<dim> &);                     \
  template std::vector<double> reference_gaps(const Elasticity<dim> &,                             \
                                              const ContactPair<dim> &,                            \
                                              const Obstacle<dim> *,                               \
                                              const BoundaryFaces<dim> &,                          \
                                              double,                                              \
                                              std::vector<PairedPoint<dim>> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
