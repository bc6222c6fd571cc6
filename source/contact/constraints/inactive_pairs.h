// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/constraints/gap_operator.h"

#include <vector>

namespace Signorini
{
  /// Pairs without any pressure, of which all of the initial overlap counts: surfaces of theirs
  /// that go through each other have not seen it. Collective.
  /// @param pressure at the rows
  std::vector<bool>
  inactive_pairs(const GapOperator &contact, const LA::Vector &pressure, unsigned int n_pairs);
} // namespace Signorini
