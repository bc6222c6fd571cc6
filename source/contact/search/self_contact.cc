// SPDX-License-Identifier: Apache-2.0
#include "contact/search/self_contact.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// A direction that is unlikely to be along an edge or axis of any model.
    template <int dim>
    Tensor<1, dim>
    skew_direction()
    {
      Tensor<1, dim> result;
      for (unsigned int d = 0; d < dim; ++d)
        result[d] = 1 / (1 + 0.37 * d);
      return result / result.norm();
    }

    /// Numbers of a sample of about a thousand faces (of all ranks together) for which opposite
    /// parts are searched. Cells are selected by a hash of their global id, so that the sample is
    /// the same on any number of ranks; it is limited since some points search far. Collective.
    template <int dim>
    std::vector<unsigned int>
    sample(const BoundaryFaces<dim> &faces, const MPI_Comm comm)
    {
      constexpr unsigned int enough = 1000;
      const unsigned int     all    = Utilities::MPI::sum(faces.faces.size(), comm),
                         stride     = std::max(1u, all / enough);
      std::vector<unsigned int> result;
      for (unsigned int i = 0; i < faces.faces.size(); ++i)
        {
          const auto &[cell, face] = faces.faces[i];
          std::uint64_t hash       = face; // Fowler, Noll, Vo
          for (const char c : cell->id().to_string())
            hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
          if ((hash >> 16) % stride == 0)
            result.push_back(i);
        }
      return result;
    }

    /// The directions from which e is chosen, one for each pair e, -e: one degree apart in 2D (a
    /// half circle), about four degrees in 3D (a spiral over the half sphere).
    template <int dim>
    std::vector<Tensor<1, dim>>
    directions()
    {
      constexpr unsigned int      many   = dim == 2 ? 180 : 1000;
      const double                golden = numbers::PI * (3 - std::sqrt(5.)); // a spiral
      std::vector<Tensor<1, dim>> result(many);
      for (unsigned int k = 0; k < many; ++k)
        {
          const double angle  = dim == 2 ? numbers::PI * k / many : golden * k,
                       height = dim == 2 ? 0 : (k + 0.5) / many;
          result[k][0]        = std::sqrt(1 - height * height) * std::cos(angle);
          result[k][1]        = std::sqrt(1 - height * height) * std::sin(angle);
          if (dim == 3)
            result[k][dim - 1] = height;
        }
      return result;
    }

    /// Parts of a surface that face each other.
    template <int dim>
    struct Facing
    {
      /// Direction e that maximises the sum of log |n . e| over these parts; zero if there are
      /// none.
      Tensor<1, dim> direction;
      /// Sum of n D^T, where n is the normal and D the vector to the opposite point in the
      /// reference configuration [length], with the weights of the score; its sign selects the side
      /// of the slaves.
      Tensor<2, dim> ways;
    };

    /// Find opposite parts by projection of the middles of a sample of faces onto the surface
    /// itself, and score all directions() by them: the sum of log(|n . e| + 0.05), weighted by the
    /// area of the face over the distance, is largest for the direction to which the normals of
    /// close parts are least perpendicular (doc/theory, 3.1). Sums are over all ranks, so that all
    /// of them choose the same direction. Cost: one search for the sample, and sample times
    /// directions. Collective.
    template <int dim>
    Facing<dim>
    facing_parts(const BoundaryFaces<dim> &faces, const double search_radius, const MPI_Comm comm)
    {
      std::vector<Point<dim>>          centers;
      std::vector<Tensor<1, dim>>      normals;
      std::vector<ReferencePoint<dim>> rest;
      std::vector<double>              sizes;
      for (const unsigned int i : sample(faces, comm))
        {
          centers.push_back(faces.patches[i].position(faces.patches[i].middle()));
          normals.push_back(faces.patches[i].normal(faces.patches[i].middle()));
          rest.push_back(reference_point(faces.rest[i], faces.rest[i].middle()));
          sizes.push_back(faces.patches[i].diameter());
        }
      const auto master_points = find_master_projections(
        centers, normals, all_faces_as_masters(faces), search_radius, comm, nullptr, {}, rest);
      // Bounds the logarithm where a normal is perpendicular to the direction.
      constexpr double    sharp = 0.05;
      const auto          all   = directions<dim>();
      std::vector<double> scores(all.size(), 0.);
      Facing<dim>         result;
      bool                is_empty = true;
      for (unsigned int i = 0; i < master_points.size(); ++i)
        {
          if (!master_points[i])
            continue;
          // Parts that are close count most; the weight is bounded as the distance vanishes.
          const double weight = std::pow(sizes[i], dim) / (sizes[i] + master_points[i]->distance);
          for (unsigned int k = 0; k < all.size(); ++k)
            scores[k] += weight * std::log(std::abs(normals[i] * all[k]) + sharp);
          result.ways += weight * outer_product(normals[i], master_points[i]->rest - rest[i].x);
          is_empty = false;
        }
      Utilities::MPI::sum(scores, comm, scores);
      result.ways = Utilities::MPI::sum(result.ways, comm);
      if (Utilities::MPI::min(is_empty ? 1 : 0, comm) == 1)
        return result;
      // Scores of symmetric models are equal up to rounding: the first of the best is taken, which
      // is the same on all ranks and for any partition.
      const double best  = *std::max_element(scores.begin(), scores.end());
      const auto   first = std::find_if(scores.begin(), scores.end(), [&](const double score) {
        return score >= best - 1e-9 * std::abs(best);
      });
      result.direction   = all[first - scores.begin()];
      return result;
    }
  } // namespace



  template <int dim>
  SelfContact<dim>::SelfContact(const BoundaryFaces<dim> &faces,
                                const double              search_radius,
                                const double              side,
                                const MPI_Comm            comm)
  {
    // The sign of e: of two choices, the one in which masters lie beyond their slaves, seen along a
    // fixed direction of the reference configuration. It depends neither on the history nor on the
    // partition.
    const Facing<dim>    facing = facing_parts(faces, search_radius, comm);
    const Tensor<1, dim> e =
      facing.direction.norm() == 0 ? skew_direction<dim>() : facing.direction;
    const double sign = e * facing.ways * skew_direction<dim>() < 0 ? -side : side;
    for (const FacePatch<dim> &patch : faces.patches)
      slaves.push_back(sign * (patch.normal(patch.middle()) * e) > 0);
  }



  template <int dim>
  BoundaryFaces<dim>
  SelfContact<dim>::masters(const BoundaryFaces<dim> &faces) const
  {
    std::vector<bool> masters = slaves;
    masters.flip();
    return faces.among(masters);
  }



  template <int dim>
  MasterFaces<dim>
  all_faces_as_masters(const BoundaryFaces<dim> &faces)
  {
    const auto tell_rest =
      [&](unsigned int i, const Point<dim - 1> &xi, MasterProjection<dim> &master_point) {
        master_point.rest = faces.rest[i].position(xi);
      };
    return {faces.patches, tell_rest, {}, faces.rest};
  }



  template <int dim>
  ReferencePoint<dim>
  reference_point(const FacePatch<dim> &rest, const Point<dim - 1> &xi)
  {
    return {rest.position(xi), rest.normal(xi), rest.piece};
  }



#define INSTANTIATE(dim)                                                                           \
  template class SelfContact<dim>;                                                                 \
  template MasterFaces<dim>    all_faces_as_masters(const BoundaryFaces<dim> &);                   \
  template ReferencePoint<dim> reference_point(const FacePatch<dim> &, const Point<dim - 1> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
