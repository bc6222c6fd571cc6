// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/parameters/section.h>

namespace Signorini
{
  /// A number of a shape, such as its radius, which may be a formula in t.
  class ShapeParameter
  {
  public:
    /// @param value the default
    explicit ShapeParameter(double value);

    /// Bind a key. Throws SceneError if the formula depends on the position, or if its value at t =
    /// 0 is not in the range.
    /// @param section of the obstacle
    /// @param key its name
    /// @param help one sentence, which ends with the unit in brackets
    /// @param range of the values
    void
    declare(Section &section, const std::string &key, const std::string &help, const Range &range);

    /// Set the time. Throws SceneError if the value is not in the range.
    void
    set_time(double t);

    /// True if the value depends on the time.
    bool
    depends_on_time() const
    {
      return formula.depends_on_time();
    }

    /// The value at the time of set_time(), initially 0.
    operator double() const
    {
      return value;
    }

  private:
    bool
    is_valid() const;

    Expression<3> formula;
    double        value;
    Range         range;
    std::string   source; ///< the key in the scene file, for messages
  };
} // namespace Signorini
