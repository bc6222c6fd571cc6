// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fields/probes.h"
#include "fields/snapshot.h"
#include "output/json.h"
#include <signorini/fields/cross_section.h>

#include <vector>

namespace Signorini
{
  /// @return for each contact pair: force and moment (about the origin) on the slave, contact area,
  /// and how well the Hertz-Signorini-Moreau conditions (doc/theory, 1.3) are satisfied. Pressure
  /// is positive in compression. Collective.
  /// @param snapshot the solution
  template <int dim>
  Json
  pair_results(const Snapshot<dim> &snapshot);

  /// @return for each support its force on the bodies; the total load; the largest of all forces on
  /// the bodies (for pairs: the sum of their absolute values); and the balance of each body and of
  /// all, i.e. the resultant divided by the largest force, and for moments also by the size of the
  /// model. Collective.
  /// @param snapshot the solution
  /// @param tolerance of Newton's method
  template <int dim>
  Json
  force_results(const Snapshot<dim> &snapshot, double tolerance);

  /// @return the motions of moving obstacles, and their forces on the bodies. Collective.
  /// @param snapshot the solution
  template <int dim>
  Json
  obstacle_results(const Snapshot<dim> &snapshot);

  /// @return the numbers of cells, ghost cells, faces to ghost cells, degrees of freedom, slave
  /// faces and contact points of each rank. Collective.
  /// @param elasticity the model
  /// @param surfaces contact surfaces of all pairs
  template <int dim>
  Json
  shares_of_ranks(const Elasticity<dim>                  &elasticity,
                  const std::vector<ContactSurface<dim>> &surfaces);

  /// @return the peak memory [MB] of each rank. Collective.
  /// @param comm the ranks
  Json
  peak_memory(MPI_Comm comm);

  /// @return the versions of deal.II and Trilinos.
  Json
  library_versions();

  /// @return position and displacement at each probe; in bodies also stress components by name
  /// ("xx", ...), principal stresses (the largest first) and von Mises stress; on pairs also
  /// pressure and gap (null where the surfaces are too far apart for the search). Lines have a list
  /// of these. Collective.
  /// @param snapshot the solution
  /// @param probes of the scene
  template <int dim>
  Json
  probe_results(const Snapshot<dim> &snapshot, const std::vector<Probe<dim>> &probes);

  /// @return force, its component along the normal (tension positive), and moment of each cross
  /// section. Collective.
  /// @param snapshot the solution
  /// @param sections of the scene
  template <int dim>
  Json
  section_results(const Snapshot<dim> &snapshot, const std::vector<CrossSection<dim>> &sections);

  /// @return the wet areas of loads with fluid entries, by the names of the loads. Collective.
  template <int dim>
  Json
  fluid_results(const Snapshot<dim> &snapshot);

  /// @return the entries of results.json of a pair with friction: force, stick zone, the largest
  /// tangential traction, slips, the work that friction takes from the bodies, and the violations
  /// of the law. Collective.
  /// @param snapshot the solution
  /// @param force the part of the force on the slave that is due to tangential tractions
  /// @param area of the contact zone
  /// @param pair its index
  template <int dim>
  Json
  friction_results(const Snapshot<dim>          &snapshot,
                   const dealii::Tensor<1, dim> &force,
                   double                        area,
                   unsigned int                  pair);

  /// The entries of a tied pair: tangential force and traction. Collective.
  /// @param snapshot the solution
  /// @param force the part of the force on the slave that is due to tangential tractions
  /// @param pair its index
  template <int dim>
  Json
  tie_results(const Snapshot<dim>          &snapshot,
              const dealii::Tensor<1, dim> &force,
              unsigned int                  pair);
} // namespace Signorini
