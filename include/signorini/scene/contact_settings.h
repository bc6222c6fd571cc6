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
    std::string method       = "Lagrange multiplier";
    bool        is_automatic = false; ///< nobody has chosen it
    std::vector<std::pair<std::string, std::shared_ptr<ContactMethod>>>
                        methods;               ///< all, each with its keys
    std::optional<Rule> integration;           ///< none: what suits the method
    unsigned int        quadrature_points = 0; ///< 0: as many as the method and the degree need
    Basis               pressure_basis    = Basis::dual; ///< of methods that sample at nodes
    ContactGeometry     geometry          = ContactGeometry::automatic;
    double              geometry_share    = 0.005; ///< of the pressure that is not worth an update

    ContactSettings();

    const ContactMethod &
    chosen() const;

    /// See ContactMethod::stiffen().
    void
    stiffen(double factor);

    /// With the number of points that the method needs where slave and master have elements of
    /// these degrees.
    Integration
    integration_of_degrees(unsigned int slave, unsigned int master) const;

    void
    declare(Section &section);
  };
} // namespace Signorini
