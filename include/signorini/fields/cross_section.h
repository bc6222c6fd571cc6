// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/point.h>

#include <string>
#include <vector>

namespace Signorini
{
  class Section;

  /// A plane through bodies, in the reference configuration, across which force and moment are
  /// reported.
  template <int dim>
  struct CrossSection
  {
    std::string name;
    /// Names of the bodies that are cut; empty: all.
    std::vector<std::string> bodies;
    /// A point of the plane, about which the moment is.
    dealii::Point<dim> point;
    /// Normal of the plane, of any length: into the part whose force on the other one is reported.
    dealii::Point<dim> normal = dealii::Point<dim>::unit_vector(0);

    /// Declare the keys and read their values. Throws SceneError.
    /// @param section of the cross section
    void
    declare(Section &section);
  };
} // namespace Signorini
