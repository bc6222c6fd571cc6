// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/displacements.h"
#include "solid/node_positions.h"

#include <array>
#include <vector>

namespace Signorini
{
  /// The rigid-body modes of a body, of size about one: dim translations, then rotations about the
  /// center of a box, scaled by half its diagonal.
  template <int dim>
  class RigidBodyModes
  {
  public:
    static constexpr unsigned int n = dim * (dim + 1) / 2;

    RigidBodyModes(const dealii::BoundingBox<dim> &box);

    /// The value of each mode in component c at x.
    std::array<double, n>
    at(const dealii::Point<dim> &x, unsigned int c) const;

    /// Half of the diagonal of the bounding box [length].
    double
    size() const
    {
      return my_size;
    }

  private:
    dealii::Point<dim> center;
    double             my_size;
  };

  /// The rigid-body modes on the degrees of freedom of this rank, mode by mode, as near null space
  /// of multigrid. One set serves all bodies: aggregates never contain nodes of two bodies, and on
  /// one body a rotation about another center differs by a translation only. Nodes of rigid bodies
  /// are coupled to no others; for aggregation each of their components counts as a translation.
  /// @param box of the bodies
  template <int dim>
  std::vector<std::vector<double>>
  rigid_body_modes(const NodePositions &nodes, const dealii::BoundingBox<dim> &box);

  /// The rigid-body modes of the bodies, mode by mode, on the locally owned degrees of freedom.
  template <int dim>
  std::vector<std::vector<double>>
  rigid_body_modes(const Displacements<dim> &displacements);

  /// The body of each locally owned degree of freedom; Mesh::n_bodies() for those of rigid ones.
  template <int dim>
  std::vector<unsigned int>
  bodies_of_dofs(const Displacements<dim> &displacements);
} // namespace Signorini
