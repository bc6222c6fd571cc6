// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "linear_algebra/types.h"

#include <vector>

namespace Signorini
{
  /// Chooses the lengths of load steps with friction so that the error of the whole path is within
  /// a tolerance (doc/theory, 8.7). The error of a load step is estimated by the change of the
  /// tangential tractions, and of the work of friction, when it is taken in two halves. It may be a
  /// share of their change in this load step, and a smaller share of the largest ones of the
  /// history: the former adds up to half of the tolerance over a history that is monotone; the
  /// latter, to the other half at most, is for its start, where contact areas grow from nothing,
  /// and the relative error of a load step does not decrease with its length.
  class PathControl
  {
  public:
    /// A solution as far as it depends on the path.
    struct Solution
    {
      /// Tangential tractions at the nodes, by component; empty: zero.
      std::vector<LA::Vector> tractions;
      double                  work = 0; ///< of friction, of all load steps so far
      /// Work that is none: rounding where all points stick.
      double negligible_work = 0;
      /// Largest relative change of the bound of friction by the slip of the load step.
      double change_of_friction = 0;
    };

    /// Sizes of solutions, or of differences of them.
    struct Size
    {
      double tractions = 0; ///< sum of absolute values over nodes and components
      double work      = 0;
    };

    /// @param tolerance of the error of the path, relative to the largest size
    explicit PathControl(double tolerance);

    /// @return the size of the difference. Collective.
    static Size
    distance(const Solution &one, const Solution &other);

    /// What load steps so far leave to those that follow.
    struct Budget
    {
      Size largest; ///< sizes in the history, of what is known of it
      Size spent;   ///< errors beyond the share of the change in their load steps
    };

    void
    set_budget(const Budget &so_far)
    {
      my_budget = so_far;
    }

    const Budget &
    budget() const
    {
      return my_budget;
    }

    /// Judge a load step. Collective.
    /// @param before solution at the start of the load step
    /// @param coarse at its end, in one step
    /// @param fine the same in two halves
    /// @return whether its error is small enough
    bool
    judge(const Solution &before, const Solution &coarse, const Solution &fine);

    /// Take the load step that was judged last, with the errors that it has.
    void
    accept();

    /// @return the error of the load step judged last, relative to the largest size: the larger one
    /// of tractions and work.
    double
    error() const
    {
      return my_error;
    }

    /// @return the factor, of at most two, by which the next load step may be longer than the one
    /// judged last.
    double
    growth() const
    {
      return my_growth;
    }

  private:
    /// Judge one number. @return whether its error is small enough
    /// @param excess out: the error, if it is more than the share of the change
    bool
    judge(double error, double change, double largest, double spent, double &excess);

    double tolerance;
    Budget my_budget;
    Size   excess; ///< of the load step judged last
    double my_error = 0, my_growth = 2;
  };
} // namespace Signorini
