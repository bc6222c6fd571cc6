// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/constraints/gap_operator.h"
#include "solver/preconditioners/hierarchy.h"

#include <memory>
#include <vector>

namespace Signorini
{
  /// The contact (penalty) stiffness B^T D B between surfaces in contact, on all levels of a
  /// hierarchy, with B P_1 P_2 ... in the place of B (doc/theory, 7.2). Without it, the coarse
  /// corrections of bodies in contact would be independent of each other. Quadrature points of a
  /// slave face share one row, their mean, and one value; so do points with the same columns.
  ///
  /// Levels count from 0, the finest. Vectors are arrays of this rank's degrees of freedom of a
  /// level.
  class LevelContactStiffness
  {
  public:
    /// Initially zero. @param contact not empty
    LevelContactStiffness(const Hierarchy &hierarchy, const GapOperator &contact);

    /// Set the stiffness.
    /// @param contact_stiffness one vector for each component, by contact point. Values above 6 k
    /// W, which between equal bodies is three times E/h, are reduced to that: they couple the
    /// bodies well enough, and larger ones would slow down the smoothers (of 1, 3, 10, 100 and 1000
    /// times E/h this took the fewest iterations).
    void
    set(const PointVectors &contact_stiffness);

    /// Set all values to the upper bound.
    void
    stiffen();

    void
    /// Set the stiffness to zero, for a multigrid cycle of the bodies alone.
    remove();

    /// True if the stiffness is not zero on some rank.
    bool
    any() const
    {
      return is_any;
    }

    /// result += diag(B^T D B) on a level, for the owned degrees of freedom. Collective.
    void
    add_diagonal(unsigned int level, float *result) const;

    /// Add for each row of B^T D B of a level the sum of the absolute values of its entries, or an
    /// upper bound of it. Collective.
    void
    add_row_sums(unsigned int level, float *result) const;

    /// dst += B^T D B src on a level. Collective.
    void
    add_product(unsigned int level, float *dst, const float *src) const;

    /// K + B^T D B as a matrix, for the coarsest level, which has few columns.
    LA::SparseMatrix
    sum_with_contact_stiffness(const LA::SparseMatrix &K, unsigned int level) const;

  private:
    /// The mean rows of the groups on a level.
    struct Level
    {
      explicit Level(LA::SparseMatrix &&matrix)
        : B(std::move(matrix))
        , single_precision(B)
      {}

      const LA::SparseMatrix B;
      const LA::LevelMatrix  single_precision;
    };

    /// The entries of B^T D B that are summed up.
    enum class Entries
    {
      diagonal,
      all
    };

    void
    add_contact_stiffness(const Level &level, Entries entries, float *result) const;
    void
    update_levels();

    /// The group of each local contact point; the value of component a of group k is at a n_groups
    /// + k.
    std::vector<unsigned int>           groups;
    unsigned int                        n_groups;
    LA::Vector                          D, limit;
    bool                                is_any = false; ///< on any rank
    std::vector<std::unique_ptr<Level>> levels;
    mutable std::vector<float>          gap; ///< workspace
  };
} // namespace Signorini
