// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/point.h>

#include <limits>
#include <vector>

namespace Signorini
{
  class Section;

  /// The relation between pressure p and overclosure d of a contact pair.
  enum class PressureOverclosure
  {
    hard,        ///< d = 0
    linear,      ///< p = k d
    exponential, ///< p = p0 100^(d/c0) where d > -c0
    tabular      ///< piecewise linear
  };

  /// The compliance of the interface of a contact pair: of rough surfaces, or of a thin elastic
  /// layer between the bodies. It is in series with what the contact method leaves open: at a
  /// solution the gap of closed points is g = -d(p), and the slip of points that stick is the
  /// tangential traction over the tangential stiffness (doc/theory, 2.12).
  struct ContactCompliance
  {
    PressureOverclosure kind = PressureOverclosure::hard;
    /// k of the linear relation [force/length^3].
    double normal_stiffness = std::numeric_limits<double>::infinity();
    /// Tangential traction per slip of points that stick [force/length^3].
    double tangential_stiffness = std::numeric_limits<double>::infinity();
    /// c0 of the exponential relation: the gap where the pressure has fallen to p0/100, and below
    /// which there is contact [length].
    double clearance = 0;
    /// p0 of the exponential relation: the pressure where the gap is zero [force/length^2].
    double pressure_at_zero_gap = 0;
    /// (p, d) of the tabular relation, both increasing, from p = 0.
    std::vector<dealii::Point<2>> table;

    /// Declare the keys.
    void
    declare(Section &section);

    /// Throws SceneError through the section for invalid combinations, after all keys of the pair
    /// were read.
    /// @param is_bonded whether points carry tension: those of tied pairs, and of pairs without
    /// separation
    /// @param has_slip_law whether the pair is tied or has friction
    void
    check_keys(Section &section, bool is_bonded, bool has_slip_law) const;

    /// True if the interface is rigid.
    bool
    is_rigid() const
    {
      return kind == PressureOverclosure::hard &&
             tangential_stiffness == std::numeric_limits<double>::infinity();
    }

    /// True if the derivative of the overclosure depends on the pressure.
    bool
    is_nonlinear() const
    {
      return kind == PressureOverclosure::exponential || kind == PressureOverclosure::tabular;
    }

    /// A value and its derivative by the pressure.
    struct Value
    {
      double value, derivative;
    };

    /// The overclosure d(p) [length]; the least one of contact for p = 0. At negative pressures,
    /// which only bonded points and iterates have, the first line of a relation continues.
    Value
    overclosure(double pressure) const;

    /// The pressure p(d), the inverse of overclosure(); negative for overclosures below that of
    /// p = 0 with a linear relation, zero with the others. Not for PressureOverclosure::hard.
    double
    pressure(double overclosure) const;

    /// The largest gap of points in contact [length], at least zero.
    double
    reach() const;

    /// The pressure p with p + epsilon (d(p) - d(0)) = trial, and its derivative by the trial
    /// value: (2.33) of doc/theory.
    /// @param trial of any sign [force/length^2]
    /// @param epsilon penalty parameter [force/length^3]
    Value
    pressure(double trial, double epsilon) const;
  };
} // namespace Signorini
