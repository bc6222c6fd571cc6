// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/interface/surface_points.h"

#include <deal.II/base/mpi.h>

#include <map>
#include <optional>
#include <vector>

namespace Signorini
{
  /// What is known of contact at a place.
  struct SurfacePointValue
  {
    SurfacePoint place{};
    double       pressure = 0; ///< positive in compression [force/length^2]
    double       status   = 0; ///< value of a ContactStatus
    /// Vectors along the surface, turned and stretched back to where it is at rest, three
    /// components each: the tangential traction on the slave, if the law has one, and internal
    /// vectors. Then internal scalars.
    std::vector<double> history;

    template <class Archive>
    void
    serialize(Archive &ar, const unsigned int)
    {
      ar &place[0] & place[1] & pressure &status &history;
    }
  };

  /// Pressure, status and history by slave face and place on it. It refers to no mesh, to no rows
  /// and no degrees of freedom: it outlives them. Each rank has the faces of some cells.
  class SurfaceField
  {
  public:
    /// @param dim that of the cells
    explicit SurfaceField(unsigned int dim = 3)
      : dim(dim)
    {}

    bool
    empty() const
    {
      return faces.empty();
    }

    void
    set(const FaceId &face, std::vector<SurfacePointValue> values)
    {
      faces[face] = std::move(values);
    }

    /// Of this rank.
    const std::map<FaceId, std::vector<SurfacePointValue>> &
    values() const
    {
      return faces;
    }

    /// What ranks have to know to ask at() for the faces that they want, whoever knew it before:
    /// these faces, and those of their cells' parents and children. Collective.
    SurfaceField
    gathered_at(const std::vector<FaceId> &wanted, MPI_Comm comm) const;

    /// The values at a place: as they were set, if they were set there; else the polynomial through
    /// those of the face (where they are on a lattice), or a plane that weighs them by their
    /// distance. Of a face that is not known, those of its parent or of its children. Empty if they
    /// are not known either.
    std::optional<SurfacePointValue>
    at(const FaceId &face, const SurfacePoint &place) const;

  private:
    unsigned int                                     dim;
    std::map<FaceId, std::vector<SurfacePointValue>> faces;
  };
} // namespace Signorini
