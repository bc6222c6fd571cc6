// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/parameters/definitions.h>
#include <signorini/parameters/expression.h>

#include <deal.II/base/point.h>

#include <optional>

namespace Signorini
{
  class Section;

  /// The strength of a bond, the points of a tied pair. A point fails where
  ///
  ///   (<-p>/S)^2 + (|t|/T)^2 >= 1
  ///
  /// with its pressure p (<.>: positive part, so that compression does no harm), its tangential
  /// traction t, the tensile strength S and the shear strength T (C. C. Brewer, P. A. Lagace, J.
  /// Composite Mater. 22 (1988) 1141-1155). It fails for good and at once: from then on its
  /// surfaces are in contact, with the friction of the pair. With a compliance e of the interface
  /// that is the linear elastic-brittle interface, whose fracture energy is e S^2/2 (L. Tavara, V.
  /// Mantic, E. Graciani, F. Paris, Eng. Anal. Bound. Elem. 35 (2011) 207-222; doc/theory, 2.16).
  template <int dim>
  struct BondStrength
  {
    /// S and T [force/length^2], formulas of the position in the reference configuration; empty:
    /// the bond does not fail, and T = S.
    Formula tensile, shear;

    /// Declare the keys.
    void
    declare(Section &section);

    /// Throws SceneError through the section for invalid combinations, after all keys of the pair
    /// were read.
    void
    check_keys(Section &section, bool is_tied, bool has_pretension);

    /// True if the bond can fail.
    bool
    given() const
    {
      return !tensile.empty();
    }

    /// @return the square root of the left-hand side of the criterion; infinite without strength
    /// @param x position in the reference configuration
    /// @param pressure true pressure, positive in compression
    /// @param shear length of the true tangential traction
    double
    utilisation(const dealii::Point<dim> &x, double pressure, double shear) const;

    /// True if there is no bond at a place, because a strength is zero there. Throws SceneError for
    /// strengths that are negative, or no number.
    bool
    is_absent(const dealii::Point<dim> &x) const;

  private:
    std::optional<Expression<dim>> S, T;
  };
} // namespace Signorini
