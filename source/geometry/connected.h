// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace Signorini
{
  /// Which of n things are connected to each other, by union and find.
  class Connected
  {
  public:
    explicit Connected(unsigned int n);

    void
    connect(unsigned int a, unsigned int b);

    /// The same number for all that are connected with each other: the smallest of them.
    unsigned int
    first_of(unsigned int a);

  private:
    std::vector<unsigned int> above;
  };
} // namespace Signorini
