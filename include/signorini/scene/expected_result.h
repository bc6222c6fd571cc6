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

  /// A reference value that the scene contains. The program compares and reports it, and its exit
  /// code depends on whether it is met.
  struct ExpectedResult
  {
    std::string name;
    /// Names of numbers in results.json, such as "F = pairs/interface/force/1".
    std::vector<std::string> quantities;
    /// Formulas in these names.
    Formula value, reference = "0";
    /// Relative tolerance; an absolute tolerance above zero replaces it.
    double      tolerance = 0.01, absolute_tolerance = 0;
    std::string source;
    /// Position of the quantities in the scene.
    std::string place;

    /// Declare the keys and read their values. Throws SceneError.
    /// @param section of the result
    void
    declare(Section &section);

    /// Replace former names of entries of results.json by present ones, with a message.
    /// @param section for messages
    /// @param dim 2 or 3
    void
    use_present_paths(Section &section, unsigned int dim);
  };

  /// Throws SceneError where a quantity cannot exist in results.json.
  /// @param expected results of the scene
  /// @param step a load step with all keys that are known before the solution, with any numbers
  /// @param whole keys of the results themselves
  void
  check_paths(const std::vector<ExpectedResult> &expected,
              const nlohmann::ordered_json      &step,
              const std::vector<std::string>    &whole);

  /// Compare with the results of the last load step: print a table, and add it to the results under
  /// "expected". Throws SceneError where a quantity does not exist.
  /// @param expected results of the scene
  /// @param results which are extended
  /// @param out the stream
  /// @return whether all are met
  bool
  compare(const std::vector<ExpectedResult> &expected,
          nlohmann::ordered_json            &results,
          std::ostream                      &out);
} // namespace Signorini
