#pragma once

#include <signorini/contact/discretisation/contact_rows.h>
#include <signorini/contact/discretisation/gap_operator.h>

namespace Signorini
{
  /// Assemble how the normal stress at the contact points depends on the rises of the temperature,
  /// GapOperator::S_thermal, once the points' areas are known; nothing if no body expands.
  template <int dim>
  void
  assemble_thermal_stress(const ThermalStrain<dim>               &thermal,
                          const ContactRows                      &rows,
                          const std::vector<ContactSurface<dim>> &surfaces,
                          GapOperator                            &contact);
} // namespace Signorini
