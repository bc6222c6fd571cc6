// SPDX-License-Identifier: Apache-2.0
#include "geometry/connected.h"

#include <algorithm>
#include <numeric>

namespace Signorini
{
  Connected::Connected(const unsigned int n)
    : above(n)
  {
    std::iota(above.begin(), above.end(), 0);
  }



  void
  Connected::connect(const unsigned int a, const unsigned int b)
  {
    const auto [first, second] = std::minmax({first_of(a), first_of(b)});
    above[second]              = first;
  }



  // Union-find with path halving; the root of a set is its smallest member.
  unsigned int
  Connected::first_of(const unsigned int a)
  {
    unsigned int first = a;
    while (above[first] != first)
      first = above[first] = above[above[first]];
    return first;
  }
} // namespace Signorini
