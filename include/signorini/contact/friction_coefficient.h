// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/parameters/definitions.h>

#include <deal.II/base/point.h>

#include <limits>
#include <memory>

namespace Signorini
{
  class CompiledFormula;
  class Section;

  /// The coefficient of Coulomb friction of a contact pair, and the largest shear stress that
  /// friction transmits.
  template <int dim>
  struct FrictionCoefficient
  {
    /// Formula of mu in the reference position, time, pressure, and slip: the length of the path
    /// over which a point has slipped before the load step [length].
    Formula mu = "0";
    /// Upper bound of the tangential traction [force/length^2].
    double limit = std::numeric_limits<double>::infinity();

    /// Declare the keys. Throws SceneError through the section for invalid formulas.
    void
    declare(Section &section);

    /// True if there is no friction: the formula is the constant zero.
    bool
    is_zero() const;

    /// True if the bound is not mu(x, t) p: by the pressure, the slip, or the limit.
    bool
    is_nonlinear() const;

    /// @return the coefficient; not a number where it is negative.
    /// @param x position in the reference configuration
    /// @param t time
    /// @param pressure positive in compression
    /// @param slip path length before the load step
    double
    value(const dealii::Point<dim> &x, double t, double pressure, double slip) const;

    /// @return the bound of the tangential traction, min(mu p, limit).
    double
    bound(const dealii::Point<dim> &x, double t, double pressure, double slip) const;

  private:
    std::shared_ptr<const CompiledFormula> compiled; ///< null: zero
  };
} // namespace Signorini
