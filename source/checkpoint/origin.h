// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace Signorini
{
  /// What a run was started with: enough to start it again from its output directory.
  struct Origin
  {
    std::string                          name;  ///< of the scene
    std::string                          scene; ///< the text of its file, with all defaults
    std::map<std::string, std::uint32_t> files; ///< which it names: meshes, STL; their checksums
  };

  /// With the checksums of the files that the scene names. Throws SceneError if one is gone.
  Origin
  origin_of(const std::string &name, const std::string &scene);

  /// Leaves it as DIRECTORY/restart.scene. Throws OutputError.
  void
  write_origin(const std::string &directory, const Origin &origin);

  /// Throws SceneError if there is none, if it is damaged, or if a file has changed since.
  Origin
  read_origin(const std::string &directory);

  /// By which a checkpoint knows its run. Throws SceneError.
  std::uint32_t
  checksum_of_origin(const std::string &directory);

  /// Throws SceneError for a key that a run must not change half-way: "Section/Key=value" of others
  /// than Newton, Solver and Output, or cut-backs.
  void
  check_change(const std::string &assignment);
} // namespace Signorini
