// SPDX-License-Identifier: Apache-2.0
#include "fields/surface_probes.h"

#include "contact/search/boundary_faces.h"
#include "contact/search/projection.h"
#include "fields/nodal_fields.h"
#include "fields/recovered_pressure.h"
#include "geometry/extent.h"
#include <signorini/fields/probe.h>
#include <signorini/parameters/raw.h>

#include <deal.II/base/mpi.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The point of a surface that is closest to a given one.
    template <int dim>
    struct SurfaceProjection
    {
      double distance = std::numeric_limits<double>::infinity();
      /// Tangential offset of the given point, in units of the allowed one.
      double beside = 0;
      /// Index of the face on this rank.
      unsigned int   face = 0;
      Point<dim - 1> xi;
      Point<dim>     place;
    };

    /// @return the closest point on the faces of this rank; faces whose box is farther than the
    /// best one so far are skipped.
    template <int dim>
    SurfaceProjection<dim>
    closest(const BoundaryFaces<dim> &faces, const Point<dim> &x, const double tolerance)
    {
      SurfaceProjection<dim> best;
      for (unsigned int f = 0; f < faces.rest.size(); ++f)
        {
          const FacePatch<dim> &patch = faces.rest[f];
          if (distance(x, patch.box()) >= best.distance)
            continue;
          const Projection<dim> at = project(x, patch);
          if (at.distance >= best.distance)
            continue;
          // Above a convex edge between two faces points have a tangential offset to both: half of
          // the distance from the surface is allowed.
          const double allowed = tolerance * patch.diameter() + 0.5 * at.distance;
          best = {at.distance, at.tangential_offset / allowed, f, at.xi, at.position};
        }
      return best;
    }

    /// @return the projections of the points on the surface, on the rank that has the closest face;
    /// on the others their distance is infinite. Throws SceneError for a point beside the surface.
    /// Collective.
    template <int dim>
    std::vector<SurfaceProjection<dim>>
    project_points(const BoundaryFaces<dim>      &faces,
                   const std::vector<Point<dim>> &points,
                   const double                   tolerance,
                   const std::string             &which,
                   const MPI_Comm                 comm)
    {
      std::vector<SurfaceProjection<dim>> own;
      std::vector<double>                 distances;
      for (const Point<dim> &x : points)
        {
          own.push_back(closest(faces, x, tolerance));
          distances.push_back(own.back().distance);
        }
      const auto         all  = Utilities::MPI::all_gather(comm, distances);
      const unsigned int rank = Utilities::MPI::this_mpi_process(comm);
      unsigned int       lost = points.size();
      for (unsigned int i = 0; i < points.size(); ++i)
        {
          const auto best =
            std::min_element(all.begin(), all.end(), [i](auto &a, auto &b) { return a[i] < b[i]; });
          if (rank != best - all.begin())
            own[i] = SurfaceProjection<dim>();
          else if (own[i].beside > 1)
            lost = std::min(lost, i);
        }
      lost = Utilities::MPI::min(lost, comm);
      if (lost < points.size())
        throw SceneError(which + "the point " + point_text(points[lost]) +
                         " has no projection onto the slave surface");
      return own;
    }
  } // namespace



  template <int dim>
  void
  check_on_surface(const Elasticity<dim>         &elasticity,
                   const std::string             &boundary,
                   const std::vector<Point<dim>> &points,
                   const double                   tolerance,
                   const std::string             &which)
  {
    project_points(BoundaryFaces<dim>(elasticity, boundary),
                   points,
                   tolerance,
                   which,
                   elasticity.mesh().communicator());
  }



  // The rank that has the closest face evaluates all fields there; the sum over ranks distributes
  // the values.
  template <int dim>
  std::vector<SurfaceValue<dim>>
  evaluate_on_slave(const Snapshot<dim>           &s,
                    const unsigned int             pair,
                    const std::vector<Point<dim>> &points,
                    const std::string             &which)
  {
    const Elasticity<dim>   &elasticity = s.elasticity;
    const MPI_Comm           comm       = elasticity.mesh().communicator();
    const BoundaryFaces<dim> faces(elasticity, s.pairs[pair].slave);
    // Closest places on the faces of this rank: the distance is finite only on the rank whose face
    // is the closest one of all ranks.
    const auto       own      = project_points(faces, points, probe_tolerance, which, comm);
    const LA::Vector pressure = elasticity.with_ghosts(recovered_pressure(s, pair)),
                     gap      = elasticity.with_ghosts(nodal_field(s, s.gap, pair)),
                     coverage = elasticity.with_ghosts(nodal_coverage(s, pair)),
                     u        = elasticity.with_ghosts(s.displacement);

    std::vector<SurfaceValue<dim>> result(points.size());
    for (unsigned int i = 0; i < points.size(); ++i)
      {
        SurfaceValue<dim> &value = result[i];
        double             known = 0;
        if (std::isfinite(own[i].distance))
          {
            const auto &[cell, f] = faces.faces[own[i].face];
            FEValues<dim> values(elasticity.mesh().mapping(),
                                 cell->get_fe(),
                                 Quadrature<dim>(
                                   unit_point<dim>(cell->reference_cell(), f, own[i].xi)),
                                 update_values);
            values.reinit(cell);
            const FEValuesExtractors::Scalar first(0); // nodal fields use the first component
            std::vector<double>              one(1);
            const auto                       scalar = [&](const LA::Vector &field) {
              values[first].get_function_values(field, one);
              return one[0];
            };
            std::vector<Tensor<1, dim>> moved(1);
            values[FEValuesExtractors::Vector(0)].get_function_values(u, moved);
            value = {own[i].place, moved[0], scalar(pressure), scalar(gap)};
            known = scalar(coverage);
          }
        // The values of all other ranks are zero, so that the sum is the value of the one that has
        // the face.
        value.place        = Point<dim>(Utilities::MPI::sum(Tensor<1, dim>(value.place), comm));
        value.displacement = Utilities::MPI::sum(value.displacement, comm);
        value.pressure     = Utilities::MPI::sum(value.pressure, comm);
        value.gap          = Utilities::MPI::sum(value.gap, comm);
        // The gap is defined only where all nodes of the face have one: the interpolated coverage
        // is 1 there.
        if (Utilities::MPI::sum(known, comm) < 1 - 1e-6)
          value.gap = std::numeric_limits<double>::quiet_NaN();
      }
    return result;
  }



  template void
  check_on_surface(const Elasticity<2> &,
                   const std::string &,
                   const std::vector<Point<2>> &,
                   double,
                   const std::string &);
  template void
  check_on_surface(const Elasticity<3> &,
                   const std::string &,
                   const std::vector<Point<3>> &,
                   double,
                   const std::string &);
  template std::vector<SurfaceValue<2>>
  evaluate_on_slave(const Snapshot<2> &,
                    unsigned int,
                    const std::vector<Point<2>> &,
                    const std::string &);
  template std::vector<SurfaceValue<3>>
  evaluate_on_slave(const Snapshot<3> &,
                    unsigned int,
                    const std::vector<Point<3>> &,
                    const std::string &);
} // namespace Signorini
