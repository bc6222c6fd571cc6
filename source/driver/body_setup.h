// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/decisions.h"
#include "solid/elasticity.h"

#include <memory>

namespace Signorini
{
  /// The bodies of a scene in one mesh, refined where the scene says. Collective.
  template <int dim>
  std::unique_ptr<Mesh<dim>>
  make_mesh(const Decisions<dim> &decisions, MPI_Comm comm);

  /// Their elasticity, with what acts on them, on that mesh; not set up yet.
  template <int dim>
  std::unique_ptr<Elasticity<dim>>
  make_elasticity(const Decisions<dim> &decisions, const Mesh<dim> &mesh);
} // namespace Signorini
