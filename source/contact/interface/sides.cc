// SPDX-License-Identifier: Apache-2.0
#include "contact/interface/sides.h"

#include <algorithm>

namespace Signorini
{
  double
  Sides::pressure_error() const
  {
    const double finer = std::max(1., 1 / size);
    return modulus * finer * finer * finer;
  }



  bool
  Sides::should_be_exchanged() const
  {
    // Between bodies of similar modulus the finer side stays the slave, since it resolves a small
    // contact area better, whatever the error of its pressure.
    constexpr double much_stiffer = 4;
    return modulus > much_stiffer &&
           pressure_error() > 2 * std::max(1., exchanged().pressure_error());
  }
} // namespace Signorini
