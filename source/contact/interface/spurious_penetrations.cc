// SPDX-License-Identifier: Apache-2.0
#include "contact/interface/pairing.h"

#include <deal.II/base/utilities.h>

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Class of a normal, one of 3^dim by the signs of those components that are not small (below
    /// sin 22.5 degrees). Points of one class are parts of one side of a body.
    template <int dim>
    unsigned int
    direction(const Tensor<1, dim> &normal)
    {
      constexpr double small  = 0.38;
      unsigned int     number = 0;
      for (unsigned int d = 0; d < dim; ++d)
        number = 3 * number + (normal[d] > small ? 2 : normal[d] < -small ? 0 : 1);
      return number;
    }
  } // namespace



  template <int dim>
  void
  drop_spurious_penetrations(const std::vector<FacePatch<dim>> &slave,
                             const MasterFaces<dim>            &master,
                             const MPI_Comm                     comm,
                             SearchStatistics                  &statistics,
                             std::vector<PairedPoint<dim>>     &points)
  {
    // Points that are deeper than this, in diameters of the slave face, are examined; the others
    // count as penetrations.
    constexpr double         shallow = 0.01;
    std::vector<std::size_t> numbers;
    std::vector<Point<dim>>  positions;
    std::vector<double>      ways;
    for (std::size_t i = 0; i < points.size(); ++i)
      {
        const MasterProjection<dim> &master_point = points[i].master_point;
        const FacePatch<dim>        &face         = slave[points[i].face];
        const Point<dim>             x            = face.position(points[i].xi);
        const double                 way = (master_point.position - x) * master_point.normal;
        if (way <= shallow * face.diameter())
          continue;
        numbers.push_back(i);
        positions.push_back(x);
        ways.push_back(way);
      }
    const double farthest =
      Utilities::MPI::max(ways.empty() ? 0. : *std::max_element(ways.begin(), ways.end()), comm);
    if (farthest == 0)
      return;
    // Depth of these points inside of the body, by the closest point of any orientation; one more
    // search, for these points only.
    const std::vector<double> depth = depths(positions, master, farthest, comm, &statistics);
    // The largest way out, by class of the normal, among the points whose projection is about the
    // shortest way out.
    std::vector<double> way_out(Utilities::fixed_power<dim>(3u), 0.);
    for (std::size_t i = 0; i < numbers.size(); ++i)
      if (double &way = way_out[direction(points[numbers[i]].master_point.normal)];
          depth[i] >= ways[i] / 2)
        way = std::max(way, ways[i]);
    Utilities::MPI::max(way_out, comm, way_out);

    // Spurious are points outside of the body, and points whose way is more than twice that of
    // their class: for them the face of the projection is not the side through which they have
    // entered.
    std::vector<bool> is_false(points.size(), false);
    for (std::size_t i = 0; i < numbers.size(); ++i)
      is_false[numbers[i]] =
        depth[i] < 0 || ways[i] > 2 * way_out[direction(points[numbers[i]].master_point.normal)];
    std::size_t kept = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (!is_false[i])
        {
          if (kept < i)
            points[kept] = std::move(points[i]);
          ++kept;
        }
    points.resize(kept);
  }



  template void
  drop_spurious_penetrations(const std::vector<FacePatch<2>> &,
                             const MasterFaces<2> &,
                             MPI_Comm,
                             SearchStatistics &,
                             std::vector<PairedPoint<2>> &);
  template void
  drop_spurious_penetrations(const std::vector<FacePatch<3>> &,
                             const MasterFaces<3> &,
                             MPI_Comm,
                             SearchStatistics &,
                             std::vector<PairedPoint<3>> &);
} // namespace Signorini
