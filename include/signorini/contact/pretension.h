// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/parameters/definitions.h>
#include <signorini/parameters/time_span.h>
#include <signorini/solid/rigid_body.h>

#include <deal.II/base/point.h>

#include <string>

namespace Signorini
{
  class Section;

  /// The pretension of a bolt over a section of its shank, whose two sides are a tied pair. The
  /// sides are tied at a distance: u^S - u^M = s d, where s, one unknown for the whole section, is
  /// the shortening of the bolt, and d the outward normal of the slave. The force that is conjugate
  /// to s is the tension over the section.
  template <int dim>
  struct Pretension
  {
    /// The tension over the section [force], as a formula in t; or instead the shortening [length].
    /// Both empty: none.
    Formula force, shortening;
    /// Until its end the force is given; then the shortening stays.
    TimeSpan driven;
    /// d; zero in the input: the mean outward normal of the slave, of unit length later.
    dealii::Point<dim> direction;

    /// Declare the keys.
    void
    declare(Section &section);

    /// Throws SceneError through the section for invalid combinations, after all keys of the pair
    /// were read.
    void
    check_keys(Section &section, bool is_tied) const;

    /// True if there is a pretension.
    bool
    given() const
    {
      return !force.empty() || !shortening.empty();
    }

    /// The rigid body whose first component is s.
    RigidBody<dim>
    body(const std::string &pair_name) const;

    /// The name of that body.
    static std::string
    body_name(const std::string &pair_name)
    {
      return "pretension of " + pair_name;
    }
  };
} // namespace Signorini
