// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/search/face_patch.h"
#include "contact/search/master_projection.h"
#include "contact/search/projection.h"

#include <deal.II/base/mpi.h>

#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace Signorini
{
  /// Of the normals of two surfaces where they may touch.
  template <int dim>
  bool
  faces_each_other(const dealii::Tensor<1, dim> &slave_normal,
                   const dealii::Tensor<1, dim> &master_normal)
  {
    return slave_normal * master_normal < -0.1;
  }

  /// The face of a master that a point had before, known by where it is.
  template <int dim>
  struct PreviousMasterFace
  {
    dealii::Point<dim> center;
    double             size = 0; ///< 0: none
  };

  /// The master side of one contact pair on this rank: the faces of locally owned cells. Supplies
  /// what the search cannot know: a face's shape functions and its stiffness.
  template <int dim>
  struct MasterFaces
  {
    std::vector<FacePatch<dim>> patches;
    /// Fill the functions, rows, `stiffness` and `bound` of a projection on face i at parameter xi;
    /// position and normal are set.
    std::function<
      void(unsigned int i, const dealii::Point<dim - 1> &xi, MasterProjection<dim> &master_point)>
      complete;
    /// The sides of each face, by the parameter that is constant there (2 d + (0 or 1)), behind
    /// which the surface goes on. Empty: nobody wants to know.
    std::vector<std::array<bool, 2 * (dim - 1)>> inner_sides = {};
    /// Where the faces were at rest, if points that were there on the same surface must not take
    /// what cannot_self_contact() for their projection. Empty: slave and master are two surfaces.
    std::vector<FacePatch<dim>> rest = {};
  };

  /// A place of a surface at rest.
  template <int dim>
  struct ReferencePoint
  {
    dealii::Point<dim>     x;
    dealii::Tensor<1, dim> normal; ///< outward
  };

  /// Of two places of one surface: these cannot touch, since they are neighbours, or on two sides
  /// of the body: what lies between them at rest is the body itself.
  /// @param width of the faces there
  template <int dim>
  bool
  cannot_self_contact(const ReferencePoint<dim> &a, const ReferencePoint<dim> &b, double width);

  /// What a search did on this rank; `projections` counts those for other ranks'
  /// points as well.
  struct SearchStatistics
  {
    unsigned long points = 0, points_sent = 0, projections = 0, fallbacks = 0;

    SearchStatistics &
    operator+=(const SearchStatistics &other)
    {
      points += other.points;
      points_sent += other.points_sent;
      projections += other.projections;
      fallbacks += other.fallbacks;
      return *this;
    }
  };

  /// For each slave point of this rank the closest place on the master surface of all ranks, if
  /// there is one within `search_radius`, facing the point (see faces_each_other()) and not
  /// beyond the rim of the surface. Collective.
  ///
  /// Points travel to the faces: every rank announces one bounding box of its master faces, points
  /// inside the inflated box go there, are projected on the faces that an R-tree yields in the
  /// order of distance, and the answers come back. No rank ever sees faces of another.
  ///
  /// Ties (a point that projects on the common edge of two faces) are broken by the face whose
  /// center is lexicographically smaller, so that the result does not depend on the partition; but
  /// a face that the point lies above goes before one whose rim it overhangs.
  ///
  /// Points with a normal of zero take faces of any orientation. Those with a former place stay
  /// with its face as long as that is no farther than 1e-3 of its size beyond the nearest: at an
  /// edge between two faces, each may push a point onto the other for ever.
  /// @param former empty, or one a point
  /// @param rest one a point where `master` says where it was at rest, else empty
  template <int dim>
  std::vector<std::optional<MasterProjection<dim>>>
  find_master_projections(const std::vector<dealii::Point<dim>>      &points,
                          const std::vector<dealii::Tensor<1, dim>>  &slave_normals,
                          const MasterFaces<dim>                     &master,
                          double                                      search_radius,
                          MPI_Comm                                    comm,
                          SearchStatistics                           *statistics = nullptr,
                          const std::vector<PreviousMasterFace<dim>> &former     = {},
                          const std::vector<ReferencePoint<dim>>     &rest       = {});

  /// Of each point of this rank, how deep it lies inside of the master's body, as far as the
  /// closest place of the surface tells, of whatever orientation; negative outside, infinity if
  /// nothing is within reach. A point behind a face that faces it may also be beyond the whole
  /// body: above a plate, whose lower side looks down as the point does not. Collective.
  template <int dim>
  std::vector<double>
  depths(const std::vector<dealii::Point<dim>> &points,
         const MasterFaces<dim>                &master,
         double                                 search_radius,
         MPI_Comm                               comm,
         SearchStatistics                      *statistics = nullptr);
} // namespace Signorini
