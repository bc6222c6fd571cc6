// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/constraints/gap_operator.h"
#include "solver/preconditioners/hierarchy.h"

#include <memory>
#include <vector>

namespace Signorini
{
  /// The springs B^T D B between surfaces in contact, on all levels of a hierarchy: as
  /// B P_1 P_2 ... to the left and right of D. Without them, the corrections of bodies that touch
  /// would know nothing of each other. Points between the same two faces share a spring.
  ///
  /// Levels count from 0, the finest. Vectors are arrays of this
  /// rank's degrees of freedom of a level.
  class LevelContactStiffness
  {
  public:
    /// None at first. @param contact not empty
    LevelContactStiffness(const Hierarchy &hierarchy, const GapOperator &contact);

    /// @param contact_stiffness a vector a component, by contact point. Those stiffer than 6 k W,
    /// which between equal bodies is three times E/h, count as that: they couple the bodies well
    /// enough, and larger ones would slow down the smoothers (of 1, 3, 10, 100 and 1000 times E/h
    /// this took the fewest iterations).
    void
    set(const PointVectors &contact_stiffness);

    /// All as stiff as they can be.
    void
    stiffen();

    void
    remove();

    /// Is there a spring on any rank?
    bool
    any() const
    {
      return is_any;
    }

    /// result += diag(B^T D B)
    void
    add_diagonal(unsigned int level, float *result) const;

    /// Adds the sums of the entries of each row (no less than their absolute values).
    void
    add_row_sums(unsigned int level, float *result) const;

    /// dst += B^T D B src
    void
    add_product(unsigned int level, float *dst, const float *src) const;

    /// K + B^T D B, for the coarsest level, which has few columns.
    LA::SparseMatrix
    sum_with_contact_stiffness(const LA::SparseMatrix &K, unsigned int level) const;

  private:
    struct Level
    {
      explicit Level(LA::SparseMatrix &&matrix)
        : B(std::move(matrix))
        , single_precision(B)
      {}

      const LA::SparseMatrix B;
      const LA::LevelMatrix  single_precision;
    };

    enum class Entries
    {
      diagonal,
      all
    };

    void
    add_contact_stiffness(const Level &level, Entries entries, float *result) const;
    void
    update_levels();

    /// Spring of each local contact point; those of component a come a * n_groups behind.
    std::vector<unsigned int>           groups;
    unsigned int                        n_groups;
    LA::Vector                          D, limit;
    bool                                is_any = false; ///< on any rank
    std::vector<std::unique_ptr<Level>> levels;
    mutable std::vector<float>          gap; ///< workspace
  };
} // namespace Signorini
