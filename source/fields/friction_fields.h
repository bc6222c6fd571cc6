// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fields/contact_patch.h"
#include "fields/snapshot.h"

#include <vector>

namespace Signorini
{
  /// @return a vector field along the surface in space components, one for each row of the gap
  /// operator. Collective.
  /// @param snapshot the solution, of a law with as many components as the dimension
  /// @param tangential the components along the tangents
  template <int dim>
  std::vector<LA::Vector>
  in_space(const Snapshot<dim> &snapshot, const PointVectors &tangential);

  /// @return the tangential traction on the slave surface of a pair by present area, component by
  /// component, as nodal fields; empty for laws without tangential components. Collective.
  /// @param snapshot the solution
  /// @param pair its index
  template <int dim>
  std::vector<LA::Vector>
  tangential_traction(const Snapshot<dim> &snapshot, unsigned int pair);

  /// @return the slip since the points came into contact along the tangents, one value for each row
  /// of the gap operator; zero at open points. Collective.
  /// @param snapshot the solution, of a law with as many components as the dimension
  template <int dim>
  PointVectors
  slip_at_points(const Snapshot<dim> &snapshot);

  /// @return the slip since the points came into contact, component by component, as nodal fields.
  /// Collective.
  /// @param snapshot the solution
  /// @param pair its index
  template <int dim>
  std::vector<LA::Vector>
  slip_since_contact(const Snapshot<dim> &snapshot, unsigned int pair);

  /// @return indicator of sticking points: 1 where a point sticks, else 0.
  /// @param status values of ContactStatus
  LA::Vector
  sticks(const LA::Vector &status);

  /// @return the zone of a pair in which points stick. At its edge the square of mu p - |t|
  /// decreases to zero linearly, as in partial slip of smooth bodies (Cattaneo, Mindlin).
  /// Collective.
  /// @param snapshot the solution, of a law with as many components as the dimension
  /// @param pair its index
  template <int dim>
  ContactPatch
  stick_zone(const Snapshot<dim> &snapshot, unsigned int pair);

  /// @return the tangential tractions of all pairs at the nodes, component by component.
  /// Collective.
  /// @param snapshot the solution
  template <int dim>
  std::vector<LA::Vector>
  all_tangential_tractions(const Snapshot<dim> &snapshot);

  /// @return the work that friction has taken from the bodies by the end of the load step, of each
  /// pair [force*length]. Collective.
  /// @param s the solution
  /// @param before the work by its start; may be empty
  template <int dim>
  std::vector<double>
  work_of_friction(const Snapshot<dim> &s, const std::vector<double> &before);

  /// @return whether tangential tractions are negligible beside the pressure, so that the solution
  /// does not depend on the path. Collective.
  /// @param tractions of the solution
  /// @param snapshot the solution
  template <int dim>
  bool
  are_negligible(const std::vector<LA::Vector> &tractions, const Snapshot<dim> &snapshot);
} // namespace Signorini
