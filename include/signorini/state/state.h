#pragma once

#include <signorini/linear_algebra/types.h>
#include <signorini/state/surface_field.h>

namespace Signorini
{
  struct GapOperator;

  /// Where a run is: all that the next load step starts from.
  struct State
  {
    LA::Vector   displacement; ///< of all degrees of freedom, without ghosts
    SurfaceField contact;
    LA::Vector   bulk_stress; ///< coefficients, on this mesh; empty: zero
    double       time = 0;
    unsigned int step = 0; ///< load steps up to that time
  };

  /// The values of all rows at their places. Collective.
  SurfaceField
  places_of_rows(const GapOperator &contact,
                 const LA::Vector  &pressure,
                 const LA::Vector  &active,
                 unsigned int       dim);

  /// The values of rows from those at places, of this mesh or of the one that it was refined from.
  /// What is not known is zero. Collective.
  void
  rows_of_places(const SurfaceField &field,
                 const GapOperator  &contact,
                 LA::Vector         &pressure,
                 LA::Vector         &active);
} // namespace Signorini
