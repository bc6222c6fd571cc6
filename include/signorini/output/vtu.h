#pragma once

#include <signorini/output/snapshot.h>

#include <string>

namespace Signorini
{
  /// Writes solution_NNNN.pvtu and its pieces (NNNN is the step) and returns its name. At
  /// reference positions: `displacement`, `von_mises`, the components of the stress in space
  /// (`stress_xx`, ..., tension positive; discontinuous between cells), and of each cell `body` and
  /// `subdomain` (the rank). Collective.
  template <int dim>
  std::string
  write_bodies(const Snapshot<dim> &snapshot, const std::string &directory);
} // namespace Signorini
