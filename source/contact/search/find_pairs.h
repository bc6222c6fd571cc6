// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh/mesh.h"
#include <signorini/contact/obstacles/obstacle.h>
#include <signorini/contact/pair.h>

#include <vector>

namespace Signorini
{
  /// Find the contact pairs of a model: boundaries of different bodies, and of bodies and
  /// obstacles, whose faces are visible from each other, not through the wall of a body, at no more
  /// than a distance. Slave is the side with the finer mesh, or the softer one if both are about as
  /// fine. Collective; the result is the same on all ranks.
  /// @param moduli Young's modulus of each body
  /// @param pattern settings that the pairs get beside their names and surfaces
  /// @param distance [length]
  template <int dim>
  std::vector<ContactPair<dim>>
  find_pairs(const Mesh<dim>                  &mesh,
             const std::vector<Obstacle<dim>> &obstacles,
             const std::vector<double>        &moduli,
             const ContactPair<dim>           &pattern,
             double                            distance);
} // namespace Signorini
