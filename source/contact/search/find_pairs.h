// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh/mesh.h"
#include <signorini/contact/obstacles/obstacle.h>
#include <signorini/contact/pair.h>

#include <vector>

namespace Signorini
{
  /// The pairs of boundaries of different bodies, and of bodies and obstacles, whose faces see each
  /// other at no more than a distance; not through the wall of a body. Slave is the side with the
  /// finer mesh, or of two that are about as fine the softer one. Collective; all ranks get the
  /// same.
  /// @param moduli Young's modulus of each body
  /// @param pattern what the pairs have beside their names and surfaces
  template <int dim>
  std::vector<ContactPair<dim>>
  find_pairs(const Mesh<dim>                  &mesh,
             const std::vector<Obstacle<dim>> &obstacles,
             const std::vector<double>        &moduli,
             const ContactPair<dim>           &pattern,
             double                            distance);
} // namespace Signorini
