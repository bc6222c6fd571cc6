// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <iosfwd>

namespace Signorini
{
  /// All sections and keys of both dimensions, as the page doc/guide/reference.md.
  void
  print_reference(std::ostream &out);
} // namespace Signorini
