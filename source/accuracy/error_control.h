// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "accuracy/error_estimate.h"
#include "accuracy/refinement.h"
#include <signorini/accuracy/goals.h>

#include <string>

namespace Signorini
{
  /// Decides, from the errors on a sequence of meshes, how the computation continues: which part of
  /// the error dominates, which cells are refined, how penalties and tolerances change (doc/theory,
  /// 8.6). All results are the same on all ranks.
  class ErrorControl
  {
  public:
    /// @param goals the quantities and their targets; the object refers to them
    /// @param settings of the refinement; the object refers to them
    /// @param least smallest sizes of the quantities to which their targets are relative; empty:
    /// none
    ErrorControl(const Goals               &goals,
                 const RefinementSettings  &settings,
                 const std::vector<double> &least = {});

    /// Replace the smallest sizes of the quantities. @param sizes one for each, or none
    void
    set_least(const std::vector<double> &sizes)
    {
      least = sizes;
    }

    /// Append the estimates on the next, finer mesh.
    /// @param on_next_mesh one entry for each quantity
    void
    add(const std::vector<QuantityEstimate> &on_next_mesh);

    /// Replace the estimates on the last mesh by those of a more accurate solution.
    /// @param on_last_mesh one entry for each quantity
    void
    replace_last(const std::vector<QuantityEstimate> &on_last_mesh);

    /// Replace the estimates on the last mesh by those with other load steps, see
    /// ErrorHistory::follow_path().
    /// @param on_last_mesh one entry for each quantity
    void
    follow_path(const std::vector<QuantityEstimate> &on_last_mesh);

    /// Set the errors of the path on the last mesh. @param sizes one for each quantity, or none
    void
    set_path(const std::vector<double> &sizes);

    /// @return whether the error bounds of all quantities are within their targets but for the
    /// errors of path and model; false if there are no targets.
    bool
    is_resolved() const;

    /// @return the histories of all quantities.
    const std::vector<ErrorHistory> &
    quantities() const
    {
      return histories;
    }

    /// @return the size to which the target of a quantity is relative: its absolute value, or the
    /// given smallest size.
    /// @param i index of the quantity
    double
    scale(unsigned int i) const;

    /// @return whether the error bounds of all quantities are within their targets; false if there
    /// are no targets.
    /// @param without_solver whether nonlinear and algebraic parts are disregarded, since the
    /// solver will continue
    bool
    is_met(bool without_solver = false) const;

    /// @return why finer meshes would not help, with the first quantity that cannot reach its
    /// target; empty if they would.
    /// @param path_is_final whether load steps cannot be shorter than they are
    std::string
    obstacle(bool path_is_final) const;

    /// @return the refinement indicator of each active cell, (8.16); zero in cells of other ranks.
    /// Without quantities it is the energy of the error. Collective.
    /// @param cells errors of the cells
    /// @param comm the ranks of the mesh
    std::vector<double>
    indicators(const CellErrors &cells, MPI_Comm comm) const;

    /// @return the share of the sum of all indicators that the refined cells contain, (8.17), so
    /// that the next mesh meets the targets if one mesh suffices (bulk chasing; Dörfler, see
    /// doc/theory).
    double
    share() const;

    /// @return the largest ratio of an error bound without model error to what the target leaves
    /// for it.
    double
    excess_error() const;

    /// @return the factor by which the errors of the mesh should decrease if this share is refined;
    /// 1 if the mesh need not change.
    double
    expected_reduction() const;

    /// @return the factor by which penalties are to be multiplied so that their error does not
    /// dominate; 1 if it does not.
    double
    stiffening() const;

    /// @return the tolerance of Newton's method with which the algebraic error is negligible on the
    /// next mesh.
    /// @param present the tolerance of the last solution
    double
    tolerance(double present) const;

    /// @return whether the targets need a finer mesh even if the errors of penalty and solver were
    /// zero; true without targets.
    bool
    needs_mesh() const;

  private:
    /// @return the target error of a quantity in its units; 0 without targets.
    double
    allowed(unsigned int i) const;

    /// @return slightly less than allowed(), for decisions before the last solution, which may
    /// change the bound.
    double
    target_error(unsigned int i) const;
    /// @return the part of the target error that the model error leaves.
    double
    allowed_of_mesh(unsigned int i) const;

    const Goals              &goals;
    const RefinementSettings &settings;
    std::vector<double>       least;
    std::vector<ErrorHistory> histories;
  };
} // namespace Signorini
