// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "mutations.h"

namespace Fuzz
{
  /// Something that the program reads.
  struct Target
  {
    std::string name, extension;
    Stock       stock;
    /// Read a file as the program does. Throws SceneError, the program's refusal; all else that is
    /// thrown is a defect.
    /// @param text of the file, which decides on what is wanted of it
    std::function<void(const std::string &file, const std::string &text)> read;
    double share = 1; ///< of all mutants, in any unit
  };

  /// All of them, with the seeds of the sources. @param sources the root of the repository
  std::vector<Target>
  all_targets(const std::string &sources);

  /// A folder for mutants that has beside it what seeds refer to; files that a reader writes there
  /// by mistake are found.
  class Scratch
  {
  public:
    explicit Scratch(const std::string &sources);
    ~Scratch();

    /// Where a mutant belongs, and the current directory.
    std::string
    folder() const;

    /// Files that have been added since the beginning, if any; they are removed.
    std::vector<std::string>
    strangers(const std::string &expected) const;

  private:
    std::string root;
  };
} // namespace Fuzz
