#pragma once

#include <signorini/contact/discretisation/gap_operator.h>
#include <signorini/solve/preconditioners/hierarchy.h>

#include <vector>

namespace Signorini
{
  /// The springs B^T D B between surfaces in contact, on all levels of a hierarchy: as
  /// B P_1 P_2 ... to the left and right of D. Without them, the corrections of bodies that touch
  /// would know nothing of each other. Points between the same two faces share a spring.
  ///
  /// Levels count from 0, the finest. Vectors are on the degrees of freedom of a level.
  class AMGSprings
  {
  public:
    /// None at first. @param contact not empty
    AMGSprings(const Hierarchy &hierarchy, const GapOperator &contact);

    /// @param springs by contact point. Those stiffer than 6 k W, which between equal bodies is
    /// three times E/h, count as that: they couple the bodies well enough, and larger ones would
    /// slow down the smoothers (of 1, 3, 10, 100 and 1000 times E/h this took the fewest
    /// iterations).
    void
    set(const LA::Vector &springs);

    /// All as stiff as they can be.
    void
    stiffen();

    void
    remove();

    /// Is there a spring on any rank? Collective.
    bool
    any() const;

    /// result += diag(B^T D B)
    void
    add_diagonal(unsigned int level, LA::Vector &result) const;

    /// Adds the sums of the entries of each row (no less than their absolute values).
    void
    add_row_sums(unsigned int level, LA::Vector &result) const;

    /// dst += B^T D B src
    void
    add_product(unsigned int level, LA::Vector &dst, const LA::Vector &src) const;

    /// K + B^T D B, for the coarsest level, which has few columns.
    LA::SparseMatrix
    added_to(const LA::SparseMatrix &K, unsigned int level) const;

  private:
    struct Level
    {
      LA::SparseMatrix B;
      LA::Vector       gap, force;
    };

    std::vector<unsigned int>  groups; ///< spring of each local contact point
    LA::Vector                 D, limit;
    mutable std::vector<Level> levels; ///< vectors are workspace
  };
} // namespace Signorini
