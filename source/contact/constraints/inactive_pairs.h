// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/constraints/gap_operator.h"

#include <vector>

namespace Signorini
{
  /// Flags of pairs that carry no pressure though their initial penetrations count in full: where
  /// their surfaces penetrate each other, the contact search has missed it. Collective.
  /// @param pressure at the rows
  std::vector<bool>
  inactive_pairs(const GapOperator &contact, const LA::Vector &pressure, unsigned int n_pairs);
} // namespace Signorini
