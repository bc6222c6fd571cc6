// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/interface/surface_points.h"

#include <deal.II/base/mpi.h>

#include <map>
#include <optional>
#include <vector>

namespace Signorini
{
  /// The contact values at a point of a slave face.
  struct SurfacePointValue
  {
    /// Parameters on the face.
    SurfacePoint place{};
    double       pressure = 0; ///< positive in compression [force/length^2]
    double       status   = 0; ///< value of a ContactStatus
    /// Tangential vectors, mapped back to the reference configuration of the surface, three
    /// components each: the tangential traction on the slave, if the law has one, and the internal
    /// vectors. Then the internal scalars.
    std::vector<double> history;

    template <class Archive>
    void
    serialize(Archive &ar, const unsigned int)
    {
      ar &place[0] & place[1] & pressure &status &history;
    }
  };

  /// Contact pressure, status and history by slave face and point on it. It refers to no mesh, no
  /// rows and no degrees of freedom, so that it outlives them. Each rank stores the faces of some
  /// cells.
  class SurfaceField
  {
  public:
    /// @param dim that of the cells
    explicit SurfaceField(unsigned int dim = 3)
      : dim(dim)
    {}

    /// True if this rank has no values.
    bool
    empty() const
    {
      return faces.empty();
    }

    /// Set the values of a face; former ones are replaced.
    void
    set(const FaceId &face, std::vector<SurfacePointValue> values)
    {
      faces[face] = std::move(values);
    }

    /// The values on this rank, by face.
    const std::map<FaceId, std::vector<SurfacePointValue>> &
    values() const
    {
      return faces;
    }

    /// The part of the field that at() needs for the given faces: these faces, and those of their
    /// cells' parents and children, from whichever rank has them. Collective.
    SurfaceField
    gathered_at(const std::vector<FaceId> &wanted, MPI_Comm comm) const;

    /// The values at a point of a face: as they were set, if there was a value at that point; else
    /// the polynomial through those of the face (where they are on a lattice), or a plane fitted
    /// with weights that decrease with the distance. A face without values takes those of its
    /// parent or of its children. Empty if they have none either.
    std::optional<SurfacePointValue>
    at(const FaceId &face, const SurfacePoint &place) const;

  private:
    unsigned int                                     dim;
    std::map<FaceId, std::vector<SurfacePointValue>> faces;
  };
} // namespace Signorini
