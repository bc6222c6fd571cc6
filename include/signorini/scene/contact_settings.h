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
  /// The configuration in which gaps and normals are evaluated.
  enum class ContactGeometry
  {
    /// The current one, if that changes the pressure; otherwise the reference configuration.
    automatic,
    /// The reference configuration (small sliding).
    reference,
    /// The current configuration (large sliding), doc/theory, 5.
    updated
  };

  /// The contact method, and how contact surfaces are integrated.
  struct ContactSettings
  {
    /// Name of the method, or "auto".
    std::string method = "Lagrange multiplier";
    std::vector<std::pair<std::string, std::shared_ptr<ContactMethod>>>
      /// All methods with their names; each has its own keys.
      methods;
    /// Integration rule; none: that which suits the method.
    std::optional<Rule> integration;
    /// Number of points in each direction; 0: as many as method and degree need.
    unsigned int quadrature_points = 0;
    /// Pressure basis of methods that sample at nodes, doc/theory, 3.4.
    Basis           pressure_basis = Basis::dual;
    ContactGeometry geometry       = ContactGeometry::automatic;
    /// Relative change of the pressure that is not worth a geometry update.
    double geometry_share = 0.005;

    /// Create all methods with their defaults.
    ContactSettings();

    /// @return whether the program chooses the method.
    bool
    is_automatic() const;

    /// @return the name of the method; with "auto" that of the method that the program takes.
    std::string
    chosen_name() const;

    /// @return the method.
    const ContactMethod &
    chosen() const;

    /// @return the integration, with the number of points that the method needs for elements of
    /// these degrees.
    /// @param slave degree of the slave body
    /// @param master degree of the master body; 0 for obstacles
    Integration
    integration_of_degrees(unsigned int slave, unsigned int master) const;

    /// Declare the keys and read their values. Throws SceneError.
    /// @param section `Contact method`
    void
    declare(Section &section);
  };
} // namespace Signorini
