// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/index_set.h>

namespace Signorini
{
  namespace LA
  {
    /// The degrees of freedom that a rank owns as a contiguous range, for fast tests and
    /// conversions.
    class OwnRange
    {
    public:
      using Index = dealii::types::global_dof_index;

      OwnRange() = default;

      explicit OwnRange(const dealii::IndexSet &owned)
        : first(owned.is_empty() ? 0 : owned.nth_index_in_set(0))
        , n(owned.n_elements())
      {}

      /// The number of owned degrees of freedom.
      std::size_t
      size() const
      {
        return n;
      }

      /// True if this rank owns the degree of freedom.
      bool
      has(const Index dof) const
      {
        return dof >= first && dof - first < n;
      }

      /// The index of an owned degree of freedom in arrays of owned elements.
      std::size_t
      local_index(const Index dof) const
      {
        return dof - first;
      }

      /// The inverse of local_index().
      Index
      dof(const std::size_t local_index) const
      {
        return first + local_index;
      }

    private:
      Index       first = 0;
      std::size_t n     = 0;
    };
  } // namespace LA
} // namespace Signorini
