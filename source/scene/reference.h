// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <iosfwd>

namespace Signorini
{
  /// Print all sections and keys of both dimensions, which is the page doc/guide/reference.md.
  /// @param out the stream
  void
  print_reference(std::ostream &out);
} // namespace Signorini
