// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/history/surface_field.h"
#include "contact/laws/contact_state.h"
#include "solid/material_history.h"

namespace Signorini
{
  /// The state at the start of a load step: the displacement from which the slip is measured, and
  /// the internal variables of contact and materials.
  struct StepStart
  {
    LA::Vector    displacement; ///< empty: nothing depends on load steps before
    SurfaceField  contact;
    CellVariables material;
    double        duration = 0; ///< of the load step
    /// The work of friction so far, see State, and the bound of friction there.
    std::vector<double> friction_work, friction_bound;
  };

  /// The state of a simulation: all that the next load step starts from.
  struct State
  {
    LA::Vector    displacement; ///< of all degrees of freedom, without ghosts
    SurfaceField  contact;      ///< with the internal variables that the law has now
    CellVariables material;     ///< internal variables of constitutive laws
    StepStart     start;
    LA::Vector    volumetric_stress; ///< coefficients, on this mesh; empty: zero
    double        time = 0;
    unsigned int  step = 0; ///< load steps up to that time
    /// The work that friction has taken from the bodies so far, of each pair with contact points
    /// [force*length]; empty: none. Points that have left the contact are part of it.
    std::vector<double> friction_work;
    /// The sum of the bounds of tangential forces over the points in contact, of each pair [force];
    /// empty: unknown.
    std::vector<double> friction_bound;
  };

  /// Scatter the values of all contact points to a surface field. Collective.
  SurfaceField
  to_surface_field(const GapOperator &contact, const ContactState &state, unsigned int dim);

  /// Gather the values of contact points from a surface field, of this mesh or of the one that it
  /// was refined from. Unknown values are zero. Collective.
  /// @param internal zeros, as many as the law has internal variables
  ContactState
  from_surface_field(const SurfaceField   &field,
                     const GapOperator    &contact,
                     const InternalFields &internal);
} // namespace Signorini
