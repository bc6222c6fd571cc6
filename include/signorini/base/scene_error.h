// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>

namespace Signorini
{
  /// An input of the user that cannot be used: a scene file, command line or mesh file. The message
  /// contains the key, its value, where it was set, and advice. Thrown by all ranks alike, because
  /// all ranks read the same input.
  class SceneError : public std::runtime_error
  {
  public:
    /// @param message which is freed of control characters, and shortened if it is very long
    explicit SceneError(const std::string &message);
  };
} // namespace Signorini
