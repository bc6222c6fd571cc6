// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh/mesh.h"
#include <signorini/scene/scene.h>

#include <deal.II/base/conditional_ostream.h>

#include <vector>

namespace Signorini
{
  /// The pairs that Names = auto stands for: all surfaces that see each other, not
  /// through the wall of a body, and of which one can move. Collective.
  /// @param out warned where surfaces may overlap that are none
  template <int dim>
  std::vector<ContactPair<dim>>
  automatic_pairs(const Scene<dim> &scene, const Mesh<dim> &mesh, dealii::ConditionalOStream &out);
} // namespace Signorini
