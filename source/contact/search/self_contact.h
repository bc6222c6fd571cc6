// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/search/boundary_faces.h"
#include "contact/search/search.h"

#include <vector>

namespace Signorini
{
  /// Of a surface that touches itself, which faces are slaves and which are masters. Where parts of
  /// it touch, their normals are opposite; so along any direction e that is not tangential there,
  /// one of them looks forward (n.e > 0: the slave) and the other one back (the master), and each
  /// place of contact is seen once, as multipliers need it. With that, the pair is one like any
  /// other, but for projections that cannot_self_contact() excludes.
  ///
  /// e is the direction to which the normals are least perpendicular where the surface looks at
  /// itself now: the largest sum of log |n.e|. Its sign is that for which masters lie beyond their
  /// slaves at rest as seen along a direction of the body, so that it depends neither on the
  /// history nor on the partition. Of parts that touch with normals across e, two slaves or two
  /// masters may meet: check_undetected_penetration() looks for that.
  template <int dim>
  class SelfContact
  {
  public:
    /// @param faces of the whole surface on this rank, where they are
    /// @param search_radius how far parts that look at each other may be apart
    /// @param side 1; or -1, if slaves and masters are to be exchanged
    /// Collective.
    SelfContact(const BoundaryFaces<dim> &faces, double search_radius, double side, MPI_Comm comm);

    /// @param slaves one a face
    explicit SelfContact(std::vector<bool> slaves)
      : slaves(std::move(slaves))
    {}

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

  /// All of the surface as masters for points on it, which tell where they were at rest. Refers to
  /// the faces.
  template <int dim>
  MasterFaces<dim>
  all_faces_as_masters(const BoundaryFaces<dim> &faces);

  /// On a face, at rest.
  template <int dim>
  ReferencePoint<dim>
  reference_point(const FacePatch<dim> &rest, const dealii::Point<dim - 1> &xi);
} // namespace Signorini
