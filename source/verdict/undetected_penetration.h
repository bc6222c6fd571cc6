// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/search/configuration.h"
#include "fields/snapshot.h"
#include "solid/elasticity.h"
#include <signorini/scene/scene.h>

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace Signorini
{
  /// The surfaces between which contact pairs detect contact. Faces are classified by kinds: the
  /// boundary id, plus the end of all boundary ids if the face is a slave of a surface in
  /// self-contact. Pairs without any pressure are inactive: if their surfaces penetrate
  /// nevertheless, the pair has not detected it (unless its initial overlap is not to count yet).
  template <int dim>
  class MonitoredSurfaces
  {
  public:
    /// @param scene the scene
    /// @param now the solution
    MonitoredSurfaces(const Scene<dim> &scene, const Snapshot<dim> &now);

    /// @return the kind of a boundary face.
    /// @param cell its cell
    /// @param face its number
    unsigned int
    kind(const CellIterator<dim> &cell, unsigned int face) const;

    /// @return whether a self-contact pair has both boundaries, which may be the same.
    /// @param a,b kinds
    bool
    is_self(unsigned int a, unsigned int b) const;

    /// @return whether an active pair detects contact between two kinds.
    /// @param a,b kinds
    bool
    is_monitored(unsigned int a, unsigned int b) const;

    /// @return whether an active pair detects contact with an obstacle.
    /// @param a a kind
    /// @param obstacle its name
    bool
    is_monitored(unsigned int a, const std::string &obstacle) const;

    /// @return whether there is a pair, active or not, with any surface of a body.
    /// @param a a kind
    /// @param body its index
    bool
    has_pair(unsigned int a, unsigned int body) const;

    /// @return whether there is a pair of both kinds, which carries no pressure.
    /// @param a,b kinds
    bool
    is_inactive(unsigned int a, unsigned int b) const;

    /// @return whether there is a pair with an obstacle, which carries no pressure.
    /// @param a a kind
    /// @param obstacle its name
    bool
    is_inactive(unsigned int a, const std::string &obstacle) const;

    /// @return the name of the first boundary that has this kind.
    /// @param kind of faces
    std::string
    name(unsigned int kind) const;

  private:
    /// @return the boundary ids of two kinds, the smaller one first.
    std::pair<unsigned int, unsigned int>
    boundaries(unsigned int a, unsigned int b) const;

    const Mesh<dim>                                &mesh;
    std::set<std::pair<unsigned int, unsigned int>> pairs, inactive_pairs, selves;
    /// Pairs of boundary id and body for which there is a contact pair.
    std::set<std::pair<unsigned int, unsigned int>>   with_bodies;
    std::set<std::pair<unsigned int, std::string>>    at_obstacles, idle_at_obstacles;
    std::set<std::pair<dealii::CellId, unsigned int>> slaves;
  };

  /// The faces that may be inside of another body or an obstacle where no pair detects contact, by
  /// boxes of moved vertices only: in most solutions there are few.
  template <int dim>
  class PenetrationCandidates
  {
  public:
    /// Find the candidates. Collective.
    /// @param scene the scene
    /// @param configuration current positions
    /// @param watched where pairs detect contact
    PenetrationCandidates(const Scene<dim>             &scene,
                          const Configuration<dim>     &configuration,
                          const MonitoredSurfaces<dim> &watched);

    /// @return whether a face may be inside of another body or of an obstacle.
    /// @param cell its cell
    /// @param face its number
    bool
    may_penetrate(const CellIterator<dim> &cell, unsigned int face) const;

    /// @return whether a face may penetrate something, or is near a face of another body that may.
    /// @param cell its cell
    /// @param face its number
    bool
    counts(const CellIterator<dim> &cell, unsigned int face) const;

  private:
    std::map<std::pair<unsigned int, unsigned int>, bool>
      /// may_penetrate() of the faces that count, by active cell and face.
      found;
  };

  /// A plane on which a support allows a body to slide, and nothing else, at all times.
  template <int dim>
  struct SymmetryPlane
  {
    std::string        boundary;
    unsigned int       body;
    dealii::Point<dim> center;
    /// Outward unit normal of the body.
    dealii::Tensor<1, dim> normal;
  };

  /// @return the planes that supports may represent as symmetry: of Type symmetry, or plane
  /// boundaries constrained along their normal only. Collective.
  /// @param scene the scene
  /// @param elasticity the model
  template <int dim>
  std::vector<SymmetryPlane<dim>>
  symmetry_planes(const Scene<dim> &scene, const Elasticity<dim> &elasticity);
} // namespace Signorini
