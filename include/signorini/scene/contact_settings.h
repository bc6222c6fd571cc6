// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/contact/methods/method.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Signorini
{
  /// The surfaces on which gaps and normals are taken.
  enum class ContactGeometry
  {
    automatic, ///< as they are now, where that changes the pressure
    reference, ///< at rest
    updated    ///< as they are now
  };

  /// The method by which contact is imposed, and how its surfaces are integrated.
  struct ContactSettings
  {
    std::string method = "Lagrange multiplier"; ///< or "auto"
    std::vector<std::pair<std::string, std::shared_ptr<ContactMethod>>>
                        methods;               ///< all, each with its keys
    std::optional<Rule> integration;           ///< none: what suits the method
    unsigned int        quadrature_points = 0; ///< 0: as many as the method and the degree need
    Basis               pressure_basis    = Basis::dual; ///< of methods that sample at nodes
    ContactGeometry     geometry          = ContactGeometry::automatic;
    double              geometry_share    = 0.005; ///< of the pressure that is not worth an update

    ContactSettings();

    /// Nobody has chosen the method.
    bool
    is_automatic() const;

    /// The name of the method; with "auto" that of the one which the program takes.
    std::string
    chosen_name() const;

    const ContactMethod &
    chosen() const;

    /// With the number of points that the method needs where slave and master have elements of
    /// these degrees.
    Integration
    integration_of_degrees(unsigned int slave, unsigned int master) const;

    void
    declare(Section &section);
  };
} // namespace Signorini
