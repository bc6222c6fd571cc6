// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/elasticity.h"

namespace Signorini
{
  /// Where fluids are to be.
  enum class FluidSpread
  {
    nowhere,
    /// Where they get from their entries past open faces, and nowhere else.
    open_faces,
    /// Where they are, and past more open faces; if there are none, also on faces next to wet ones
    /// whose contact pressure is less than that of the fluid, and past open faces from there.
    next_faces,
    /// As open_faces, if surfaces have closed behind the edges of the wet region; else no change.
    without_closed_faces
  };

  /// What contact points do to their surfaces, as forces on all degrees of freedom.
  struct PointForces
  {
    LA::Vector pressure; ///< of the contact pressures alone [force]
    /// Of unit pressures at all points that touch, and at those that are tied [area].
    LA::Vector touching, tied;
  };

  /// Let the fluids of loads with entries spread (doc/theory, 2.17). Faces that share a vertex are
  /// neighbours. Throws SolverFailure where two fluids meet, and SceneError for an entry that is
  /// not on the boundaries of its load, on all ranks. Collective.
  /// @param u displacement
  /// @return whether loads have changed
  template <int dim>
  bool
  spread_fluids(const Elasticity<dim> &elasticity,
                const LA::Vector      &u,
                const PointForces     &forces,
                FluidSpread            spread);

  /// Throws SceneError on all ranks for an entry that is not on the boundaries of its load, and for
  /// a body that has none. Collective.
  template <int dim>
  void
  check_fluid_entries(const Elasticity<dim> &elasticity);

  /// The area on which the fluid of a load acts.
  struct WetArea
  {
    double wet = 0, total = 0; ///< [reference area]
    /// The force of the fluid on the dry faces next to wet ones [force]: faces are wet or dry as a
    /// whole.
    double at_edge = 0;
  };

  /// @return the wet area of a load with entries. Collective.
  template <int dim>
  WetArea
  wet_area(const Elasticity<dim> &elasticity, const Load<dim> &load);

  /// True if any load is a fluid with entries.
  template <int dim>
  bool
  has_fluids(const std::vector<Load<dim>> &loads);
} // namespace Signorini
