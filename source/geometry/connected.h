// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace Signorini
{
  /// Disjoint sets of n items, by union-find; all operations take nearly constant time on average.
  class Connected
  {
  public:
    /// @param n number of items, of which each is a set of its own
    explicit Connected(unsigned int n);

    /// Unite the sets of two items.
    /// @param a,b the items
    void
    connect(unsigned int a, unsigned int b);

    /// @return the smallest item of a set, which represents it.
    /// @param a any item of the set
    unsigned int
    first_of(unsigned int a);

  private:
    std::vector<unsigned int> above;
  };
} // namespace Signorini
