// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "accuracy/error_estimate.h"
#include "accuracy/refinement.h"
#include <signorini/accuracy/goals.h>

#include <string>

namespace Signorini
{
  /// Sees the errors on one mesh after the other, and says what is worth doing about them: what
  /// dominates. All that it says is the same on all ranks.
  class ErrorControl
  {
  public:
    /// Refers to the goals and settings.
    /// @param least sizes of the quantities that their targets are relative to; empty: none
    ErrorControl(const Goals               &goals,
                 const RefinementSettings  &settings,
                 const std::vector<double> &least = {});

    /// The errors on one mesh more, finer than those before.
    void
    add(const std::vector<QuantityEstimate> &on_next_mesh);

    /// On the last mesh, of a solution that goes farther.
    void
    replace_last(const std::vector<QuantityEstimate> &on_last_mesh);

    const std::vector<ErrorHistory> &
    quantities() const
    {
      return histories;
    }

    /// What the target of a quantity is relative to.
    double
    scale(unsigned int i) const;

    /// All bars are within their targets; of some, if the solver is left out: it goes on.
    bool
    is_met(bool without_solver = false) const;

    /// Why finer meshes would not help, by the quantity that cannot be had; empty: they would.
    std::string
    obstacle() const;

    /// By what a cell matters: the sum over the quantities that are not met yet, each in units of
    /// what it may lack; without quantities the energy of the error. Collective.
    std::vector<double>
    indicators(const CellErrors &cells, MPI_Comm comm) const;

    /// The share of the sum of all indicators that the refined cells have, so that the next mesh
    /// meets the targets if it can be had by one (Doerfler, SIAM J. Numer. Anal. 33 (1996) 1106).
    double
    share() const;

    /// The largest bar of what finer meshes help, over what the target leaves for it.
    double
    excess_error() const;

    /// By what the errors of the mesh should fall if it is refined by that share.
    double
    expected_reduction() const;

    /// By what penalties should be multiplied, so that they do not dominate; 1: they do not.
    double
    stiffening() const;

    /// The tolerance of Newton's method with which what it leaves does not count.
    /// @param present with which the last solution was made
    double
    tolerance(double present) const;

    /// The mesh is fine enough, if the penalty becomes stiffer.
    bool
    needs_mesh() const;

  private:
    double
    allowed(unsigned int i) const;

    /// A bit less, before the last solution, which may change the bar.
    double
    target_error(unsigned int i) const;
    double
    allowed_of_mesh(unsigned int i) const;

    const Goals              &goals;
    const RefinementSettings &settings;
    const std::vector<double> least;
    std::vector<ErrorHistory> histories;
  };
} // namespace Signorini
