// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <iosfwd>
#include <string>

namespace Signorini
{
  /// Write the scene that an input file of Abaqus or CalculiX describes: a body for each connected
  /// piece of solids with its material, supports, loads, contact pairs and load steps. The scene
  /// refers to the file for the mesh. What the program does not model is omitted, and listed at the
  /// top of the scene and in `messages`. Throws SceneError if no elastic solid is left, or if a
  /// line is not understood.
  /// @param file path of the input file
  /// @param out receives the scene
  /// @param messages receives one warning for each omission
  void
  import_deck(const std::string &file, std::ostream &out, std::ostream &messages);
} // namespace Signorini
