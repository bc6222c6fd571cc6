// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/history/surface_field.h"
#include "contact/laws/contact_state.h"
#include "solid/material_history.h"

namespace Signorini
{
  /// Where the load step has started that led to a state: what slip counts from, and the internal
  /// variables of contact and of materials then.
  struct StepStart
  {
    LA::Vector    displacement; ///< empty: nothing depends on load steps before
    SurfaceField  contact;
    CellVariables material;
    double        duration = 0; ///< of the load step
  };

  /// Where a run is: all that the next load step starts from.
  struct State
  {
    LA::Vector    displacement; ///< of all degrees of freedom, without ghosts
    SurfaceField  contact;      ///< with the internal variables that the law has now
    CellVariables material;     ///< internal variables of constitutive laws
    StepStart     start;
    LA::Vector    volumetric_stress; ///< coefficients, on this mesh; empty: zero
    double        time = 0;
    unsigned int  step = 0; ///< load steps up to that time
  };

  /// The values of all contact points at their places. Collective.
  SurfaceField
  to_surface_field(const GapOperator &contact, const ContactState &state, unsigned int dim);

  /// The values of contact points from those at places, of this mesh or of the one that it was
  /// refined from. What is not known is zero. Collective.
  /// @param internal zeros, as many as the law has
  ContactState
  from_surface_field(const SurfaceField   &field,
                     const GapOperator    &contact,
                     const InternalFields &internal);
} // namespace Signorini
