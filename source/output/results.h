// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fields/snapshot.h"
#include "output/json.h"

namespace Signorini
{
  /// Per contact pair: force and moment (about the origin) on the slave, contact area, and how well
  /// the Hertz-Signorini-Moreau conditions (doc/theory, 1.3) hold. Forces act on the slave;
  /// pressure is positive in compression.
  template <int dim>
  Json
  pair_results(const Snapshot<dim> &snapshot);

  /// Per support the force that it exerts, the total load, the largest of all forces on the
  /// bodies (of pairs: the sum of their sizes), and the balance of each body and of all: the sum of
  /// what acts divided by that, of moments by that and the size of the scene.
  template <int dim>
  Json
  force_results(const Snapshot<dim> &snapshot, double tolerance);

  /// Numbers of cells, of ghost cells and of faces to them, of degrees of freedom, slave faces and
  /// contact points of each rank. Collective.
  template <int dim>
  Json
  shares_of_ranks(const Elasticity<dim>                  &elasticity,
                  const std::vector<ContactSurface<dim>> &surfaces);

  /// Peak memory of each rank in MB.
  Json
  peak_memory(MPI_Comm comm);

  /// deal.II, Trilinos, p4est, MPI.
  Json
  library_versions();
} // namespace Signorini
