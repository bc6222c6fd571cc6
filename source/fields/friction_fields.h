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

  /// @return at slipping points the ratio of the bound of friction after the slip of the load step
  /// to that before it, with which the step was solved; one elsewhere. It differs from one where
  /// the coefficient depends on the slip.
  /// @param snapshot the solution
  template <int dim>
  LA::Vector
  ratio_of_friction(const Snapshot<dim> &snapshot);

  /// @return the change of the bound of friction of a pair by the slip of the load step, the sum
  /// over its points relative to that of the bound. Collective.
  /// @param snapshot the solution
  /// @param pair its index
  template <int dim>
  double
  change_of_friction(const Snapshot<dim> &snapshot, unsigned int pair);

  /// @return a bound of the rounding of pressures [force/area]. Collective.
  /// @param size of the model [length]
  /// @param contact the gap operator
  /// @param u displacement
  double
  rounding_of_pressure(double size, const GapOperator &contact, const LA::Vector &u);

  /// @return the tangential tractions of all pairs at the nodes, component by component, but zero
  /// where points slip with a coefficient that depends on the slip: these are as accurate as the
  /// coefficient, see change_of_friction(), in any number of load steps. Collective.
  /// @param snapshot the solution
  template <int dim>
  std::vector<LA::Vector>
  tractions_of_path(const Snapshot<dim> &snapshot);

  /// @return the sum of the bounds of tangential forces over the points of each pair that are in
  /// contact [force]. Collective.
  template <int dim>
  std::vector<double>
  bound_of_friction(const Snapshot<dim> &s);

  /// @return the mean of the bounds of friction of a pair before and after the load step, relative
  /// to the latter; 1 if the former is unknown.
  /// @param bound after the load step [force]
  template <int dim>
  double
  relative_mean_bound(const Snapshot<dim> &s, unsigned int pair, double bound);

  /// @return the work that friction has taken from the bodies by the end of the load step, of each
  /// pair [force*length]. That of the load step is made by the mean of the bounds before and after
  /// it (doc/theory, (2.30)). Collective.
  /// @param s the solution
  /// @param before the work by its start; may be empty
  /// @param bounds bound_of_friction() of the solution
  template <int dim>
  std::vector<double>
  work_of_friction(const Snapshot<dim>       &s,
                   const std::vector<double> &before,
                   const std::vector<double> &bounds);

  /// @return whether tangential tractions are not negligible beside the pressure: only then does
  /// the solution depend on the path. Collective.
  /// @param snapshot the solution
  template <int dim>
  bool
  has_tangential_forces(const Snapshot<dim> &snapshot);
} // namespace Signorini
