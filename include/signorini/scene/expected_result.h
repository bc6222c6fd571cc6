// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/parameters/definitions.h>

#include <nlohmann/json_fwd.hpp>

#include <iosfwd>
#include <string>
#include <vector>

namespace Signorini
{
  class Section;

  /// What the scene's author knows about the answer: the program compares and reports it, and
  /// its exit code says whether it holds.
  struct ExpectedResult
  {
    std::string              name;
    std::vector<std::string> quantities; ///< "F = pairs/interface/force/1"
    Formula                  value, reference = "0";
    double                   tolerance = 0.01, absolute_tolerance = 0;
    std::string              source;
    std::string              place; ///< where the quantities are set

    void
    declare(Section &section);

    /// Former names of entries of results.json become present ones, with a note.
    void
    use_present_paths(Section &section, unsigned int dim);
  };

  /// Throws SceneError where a quantity cannot exist.
  /// @param step what is known of one load step before it is solved: all keys, with any numbers
  /// @param whole keys of the results themselves
  void
  check_paths(const std::vector<ExpectedResult> &expected,
              const nlohmann::ordered_json      &step,
              const std::vector<std::string>    &whole);

  /// Compare with the results of the last load step; print a table; add it to the results under
  /// "expected". Returns true if all hold. Throws SceneError where a quantity does not exist.
  bool
  compare(const std::vector<ExpectedResult> &expected,
          nlohmann::ordered_json            &results,
          std::ostream                      &out);
} // namespace Signorini
