#pragma once

#include <string>
#include <vector>

namespace Signorini
{
  /// What a run was started with: enough to start it again from its output directory.
  struct Origin
  {
    std::string              name;    ///< of the scene
    std::string              scene;   ///< the text of its file, with all defaults
    std::vector<std::string> folders; ///< where its mesh files are looked for
  };

  /// Leaves it as DIRECTORY/restart.scene. Throws OutputError.
  void
  write_origin(const std::string &directory, const Origin &origin);

  /// Throws SceneError if there is none, or if it is damaged.
  Origin
  read_origin(const std::string &directory);

  /// Throws SceneError for a key that a run must not change half-way: "Section/Key=value" of others
  /// than Newton, Solver and Output.
  void
  check_change(const std::string &assignment);
} // namespace Signorini
