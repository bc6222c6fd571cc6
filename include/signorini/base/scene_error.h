// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>

namespace Signorini
{
  /// Something that the user asked for and that cannot be done: a bad scene file, command line or
  /// mesh file. The message names the key, its value, where it was set, and the cure. All ranks
  /// throw it alike, because all ranks read the same input. What files have that nobody can read,
  /// control characters and endless words, is not in it.
  class SceneError : public std::runtime_error
  {
  public:
    explicit SceneError(const std::string &message);
  };
} // namespace Signorini
