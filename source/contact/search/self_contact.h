// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/search/boundary_faces.h"
#include "contact/search/search.h"

#include <vector>

namespace Signorini
{
  /// Partition of a self-contact surface into slave and master faces. Where parts of it touch,
  /// their normals are opposite; so along any direction e that is not tangential there, one part
  /// faces forward (n.e > 0: the slave) and the other one backward (the master), and each contact
  /// is counted once, as multipliers require. With that, the pair is treated as any other, but for
  /// projections that cannot_self_contact() excludes.
  ///
  /// e is the direction to which the normals are least perpendicular where parts of the surface
  /// face each other now: it maximises the sum of log |n.e|. Its sign is chosen so that masters lie
  /// beyond their slaves in the reference configuration as seen along a direction of the body, so
  /// that the result depends neither on the history nor on the partition. Where parts touch whose
  /// normals are perpendicular to e, two slaves or two masters may meet:
  /// check_undetected_penetration() reports that.
  template <int dim>
  class SelfContact
  {
  public:
    /// Choose the direction e. Collective.
    /// @param faces of the whole surface on this rank, in the current configuration
    /// @param search_radius largest distance of parts that may touch [length]
    /// @param side 1; or -1 to exchange slaves and masters
    SelfContact(const BoundaryFaces<dim> &faces, double search_radius, double side, MPI_Comm comm);

    /// A given partition. @param slaves one flag for each face
    explicit SelfContact(std::vector<bool> slaves)
      : slaves(std::move(slaves))
    {}

    /// True if the face is a slave, false if it is a master.
    bool
    is_slave(const unsigned int face) const
    {
      return slaves[face];
    }

    /// The masters among the faces of the whole surface.
    BoundaryFaces<dim>
    masters(const BoundaryFaces<dim> &faces) const;

  private:
    std::vector<bool> slaves;
  };

  /// All faces of the surface as masters of points on it, with their reference geometry. Refers to
  /// the faces.
  template <int dim>
  MasterFaces<dim>
  all_faces_as_masters(const BoundaryFaces<dim> &faces);

  /// The reference point at parameter xi of a face. @param rest the face in the reference
  /// configuration
  template <int dim>
  ReferencePoint<dim>
  reference_point(const FacePatch<dim> &rest, const dealii::Point<dim - 1> &xi);
} // namespace Signorini
