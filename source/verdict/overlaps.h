// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/search/boundary_faces.h"
#include "contact/search/search.h"
#include "contact/search/search_radius.h"
#include "contact/search/self_contact.h"
#include "geometry/cell_rule.h"
#include "verdict/undetected_penetration.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

namespace Signorini
{
  /// Overlaps of inactive pairs that are smaller than this share of a cell are attributed to
  /// facets.
  constexpr double much_of_cell = 0.2;

  /// What a surface penetrates.
  enum class PenetrationType
  {
    /// Another surface, of the same body or another one.
    other,
    /// Another body, in which the surface is deeper than the distance to any of its surfaces that
    /// would detect it.
    body,
    /// A surface in self-contact, whose points were assigned to the same side.
    itself,
    /// An obstacle of the scene.
    obstacle,
    /// A plane of symmetry of its own body, behind which is the mirror image.
    symmetry
  };

  /// The deepest penetration; penetrations that make the solution invalid have priority over
  /// others.
  struct Overlap
  {
    /// Share of a cell up to which a penetration passes.
    static constexpr double small = 0.02;

    /// Depth relative to the cells behind the faces, and as a length.
    double share = 0, depth = 0;
    /// Kind of the surface, see MonitoredSurfaces.
    unsigned int    surface          = 0;
    PenetrationType penetration_type = PenetrationType::other;
    /// Kind of the other surface, or index of the body, obstacle or plane.
    unsigned int what = 0;
    /// Whether there is a pair, which has not detected it.
    bool is_inactive = false;
    /// Whether it exists in the reference configuration.
    bool at_start = false;

    /// @return whether the penetration makes the solution invalid.
    bool
    fails() const
    {
      return share > small && (penetration_type == PenetrationType::itself || is_inactive ||
                               (at_start && penetration_type == PenetrationType::body));
    }

    /// Replace this penetration by another one if that is more severe.
    void
    take(const Overlap &other)
    {
      if (other.fails() != fails())
        {
          if (other.fails())
            *this = other;
          return;
        }
      // Of those of equal depth up to rounding the first, so that the result does not depend on
      // the partition.
      const bool is_alike = std::abs(other.share - share) <= 1e-6 * share;
      if (is_alike ? std::tie(other.surface, other.what) < std::tie(surface, what) :
                     other.share > share)
        *this = other;
    }
  };

  /// The current surface of one body, and sample points on it that are tested; at small strain
  /// only faces that may penetrate something have points.
  template <int dim>
  struct BodySurface
  {
    /// Sample the faces. Collective.
    BodySurface(const BoundaryFaces<dim>                        &of_body,
                const MonitoredSurfaces<dim>                    &watched,
                const std::optional<PenetrationCandidates<dim>> &near,
                const MPI_Comm                                   comm)
      : faces(of_body)
    {
      // Sample points are the 2-point Gauss points of each face, so that points on common edges
      // of two faces are avoided.
      for (unsigned int i = 0; i < faces.faces.size(); ++i)
        {
          const auto &[cell, face] = faces.faces[i];
          kinds.push_back(watched.kind(cell, face));
          const FacePatch<dim> &patch = faces.patches[i];
          // The deepest cell of the body limits the range of the search; it is taken of all faces,
          // also of those without points.
          deepest = std::max(deepest, faces.depth(i));
          if (near && !near->may_penetrate(cell, face))
            continue;
          for (const dealii::Point<dim - 1> &xi :
               cell_rule<dim - 1>(patch.reference_cell(), 2).get_points())
            {
              places.push_back(patch.position(xi));
              normals.push_back(patch.normal(xi));
              rest.push_back(reference_point(faces.rest[i], xi));
              face_of.push_back(i);
            }
        }
      deepest = dealii::Utilities::MPI::max(deepest, comm);
      if (deepest > 0)
        box = box_of(faces.patches, comm);
    }

    /// @return the depth up to which penetrations are detected at a sample point: beyond half a
    /// cell the opposite side may have been passed.
    double
    depth(const unsigned int place) const
    {
      return faces.depth(face_of[place]) / 2;
    }

    /// @return the faces as master surfaces for a closest-point search.
    /// @param know_rest whether reference positions are included, by which self-contact excludes
    /// neighbours
    MasterFaces<dim>
    masters(const bool know_rest) const
    {
      const auto tell = [this](unsigned int i,
                               const dealii::Point<dim - 1> &,
                               MasterProjection<dim> &master_point) {
        master_point.kind = kinds[i];
        master_point.size = faces.depth(i) / 2;
      };
      MasterFaces<dim> result{faces.patches, tell, {}, {}};
      if (know_rest)
        result.rest = faces.rest;
      return result;
    }

    /// @return the faces in the reference configuration as master surfaces.
    MasterFaces<dim>
    reference_masters() const
    {
      const auto tell = [](unsigned int, const dealii::Point<dim - 1> &, MasterProjection<dim> &) {
      };
      return {faces.rest, tell, {}, {}};
    }

    BoundaryFaces<dim> faces;
    /// Kind of each face.
    std::vector<unsigned int>           kinds;
    std::vector<dealii::Point<dim>>     places;
    std::vector<dealii::Tensor<1, dim>> normals;
    std::vector<ReferencePoint<dim>>    rest;
    std::vector<unsigned int>           face_of;
    double                              deepest = 0;
    /// Bounding box of all ranks; none if there are no faces.
    std::optional<dealii::BoundingBox<dim>> box;
  };

  /// @return the deepest penetration of sample points of a behind the closest faces of b (which
  /// may be the same body), where no active pair detects contact. Collective.
  template <int dim>
  Overlap
  overlap_of(const BodySurface<dim>       &a,
             const BodySurface<dim>       &b,
             const MonitoredSurfaces<dim> &watched,
             MPI_Comm                      comm);

  /// @return the deepest sample point of a that was outside of b in the reference configuration
  /// and is now deeper inside than half a cell; or that has been inside from the start, unless
  /// there is a pair with that body, whose overlap may have to remain for a while. Collective.
  template <int dim>
  Overlap
  depth_inside(const BodySurface<dim>       &a,
               const BodySurface<dim>       &b,
               unsigned int                  body,
               const MonitoredSurfaces<dim> &watched,
               MPI_Comm                      comm);

  /// @return the deepest penetration of two bodies that overlap from the start by more than their
  /// surfaces can detect. Some faces are tested, since others beside them are as deep.
  /// Collective.
  template <int dim>
  Overlap
  initial_depth(const Configuration<dim>     &configuration,
                unsigned int                  a,
                unsigned int                  b,
                const MonitoredSurfaces<dim> &watched);

  /// @return the deepest penetration of a surface into an obstacle.
  /// @param number of the obstacle
  /// @param belongs whether points that are inside in the reference configuration may be there
  template <int dim>
  Overlap
  overlap_of(const Configuration<dim>     &configuration,
             const BodySurface<dim>       &a,
             const Obstacle<dim>          &obstacle,
             unsigned int                  number,
             bool                          belongs,
             const MonitoredSurfaces<dim> &watched);

  /// @return the deepest penetration of a surface into a plane of symmetry of its body.
  /// @param number of the plane
  template <int dim>
  Overlap
  overlap_of(const Configuration<dim>     &configuration,
             const BodySurface<dim>       &a,
             const SymmetryPlane<dim>     &plane,
             unsigned int                  number,
             const Scene<dim>             &scene,
             const MonitoredSurfaces<dim> &watched);
} // namespace Signorini
