// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/lac/trilinos_sparsity_pattern.h>

namespace Signorini
{
  namespace LA
  {
    /// What a SparseMatrix is made of, entry by entry, on any rank.
    using SparsityPattern = dealii::TrilinosWrappers::SparsityPattern;
  } // namespace LA
} // namespace Signorini
