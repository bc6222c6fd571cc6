// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/elasticity.h"

namespace Signorini
{
  /// How far fluids spread along the boundaries of their loads.
  enum class FluidSpread
  {
    /// From the entries past faces without contact pressure; nothing is wet before.
    open_faces,
    /// Onto faces next to wet ones whose contact pressure is less than that of the fluid, and from
    /// there past faces without contact pressure.
    next_faces
  };

  /// Let the fluids of loads with entries spread (doc/theory, 2.17). Faces that share a vertex are
  /// neighbours. Throws SceneError on all ranks for an entry that is not on the boundaries of its
  /// load. Collective.
  /// @param u displacement
  /// @param contact_force of the contact pressures alone, on all degrees of freedom [force]
  /// @param tied_force of a unit pressure at all tied points, which are sealed
  /// @return whether the wet faces have changed
  template <int dim>
  bool
  spread_fluids(const Elasticity<dim> &elasticity,
                const LA::Vector      &u,
                const LA::Vector      &contact_force,
                const LA::Vector      &tied_force,
                FluidSpread            spread);

  /// Throws SceneError on all ranks for an entry that is not on the boundaries of its load.
  /// Collective.
  template <int dim>
  void
  check_fluid_entries(const Elasticity<dim> &elasticity);

  /// The area on which the fluid of a load acts.
  struct WetArea
  {
    double wet = 0, total = 0; ///< [reference area]
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
