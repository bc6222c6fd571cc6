// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace Signorini
{
  /// What is needed to restart a run from its output directory.
  struct Origin
  {
    /// Name of the scene.
    std::string name;
    /// Text of the scene with all defaults.
    std::string scene;
    /// Checksums of the files that the scene names (meshes, STL), by path.
    std::map<std::string, std::uint32_t> files;
    /// Of a scene that adds load steps to a finished run: the checksum of the origin of that run;
    /// otherwise zero.
    std::uint32_t continues = 0;
    /// The time at which that run has ended.
    double begin = 0;
  };

  /// @return the origin of a run. Throws SceneError if a file that the scene names cannot be read.
  /// @param name of the scene
  /// @param scene its text with all defaults
  Origin
  origin_of(const std::string &name, const std::string &scene);

  /// Write DIRECTORY/restart.scene. Throws OutputError.
  /// @param directory of the run
  /// @param origin of the run
  void
  write_origin(const std::string &directory, const Origin &origin);

  /// @return the origin of a run. Throws SceneError if there is none, if it is damaged, or if a
  /// file has changed since.
  /// @param directory of the run
  Origin
  read_origin(const std::string &directory);

  /// @return a checksum by which checkpoints are assigned to a run. Throws SceneError.
  /// @param directory of the run
  std::uint32_t
  checksum_of_origin(const std::string &directory);

  /// @return whether a key defines what happens in further load steps: loads, supports, times of
  /// contact pairs, and load steps.
  /// @param assignment "Section/Key=value"
  bool
  is_of_further_steps(const std::string &assignment);

  /// Throws SceneError for a key that a restart must not change: all except those of Newton, Solver
  /// and Output, and Load steps/Cut-backs; and, after a finished run, those of further load steps.
  /// @param assignment "Section/Key=value"
  void
  check_change(const std::string &assignment, bool is_finished);
} // namespace Signorini
