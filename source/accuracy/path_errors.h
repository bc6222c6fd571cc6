// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace Signorini
{
  /// The errors of quantities by the length of load steps, from load histories in which each load
  /// step was solved in different numbers of equal parts, (8.18). The order in which the errors
  /// decrease is seen, and not assumed.
  class PathErrors
  {
  public:
    /// [load step][quantity]
    using Values = std::vector<std::vector<double>>;

    /// Set the values of histories, each with twice the number of parts of the one before. With two
    /// of them, the errors decrease as they have done when there were three; with one the history
    /// has no solution with more parts, and the errors are as large as the values.
    /// @param parts of the first history
    /// @param histories at least one, with as many load steps and quantities
    void
    set(unsigned int parts, const std::vector<Values> &histories);

    /// @return whether nothing is known.
    bool
    empty() const
    {
      return changes.empty();
    }

    /// @return whether three histories have told how errors decrease.
    bool
    knows_rate() const
    {
      return has_rate;
    }

    /// @return the errors of all quantities at the end of a load step [quantity units]; without
    /// sign.
    /// @param load_step its number
    /// @param parts in which each load step is solved: a power of two times that of set(). More
    /// parts than were tried have errors that decrease at the same rate.
    std::vector<double>
    errors(unsigned int load_step, unsigned int parts) const;

  private:
    /// What is known of a quantity at the end of a load step.
    struct Change
    {
      /// Changes of the value with each doubling of the number of parts.
      std::vector<double> by_doubling;
      /// Factor by which they decrease.
      double ratio;
      /// Error if nothing else is known.
      double size;
    };

    unsigned int                     first_parts = 1;
    bool                             has_rate    = false;
    std::vector<std::vector<Change>> changes; ///< [load step][quantity]
  };
} // namespace Signorini
