// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fields/snapshot.h"
#include <signorini/fields/probe.h>

#include <string>
#include <vector>

namespace Signorini
{
  /// The name of a quantity of interest: "WHAT [COMPONENT] of NAME", as "force of interface",
  /// "force y of interface", "reaction of base", "stress xx of tip"; or "energy".
  struct QuantityName
  {
    std::string text;
    /// The kind, such as "force".
    std::string what;
    /// The component, such as "y"; may be empty.
    std::string component;
    /// The name of a pair, support, obstacle, body or probe; may be empty.
    std::string of;
  };

  /// The names to which quantities of a scene may belong.
  struct QuantityNames
  {
    std::vector<std::string> pairs, supports, obstacles, bodies;
    /// Points in bodies.
    std::vector<std::string> probes;
    /// Points on contact pairs.
    std::vector<std::string> surface_probes;
  };

  /// Interpret the name of a quantity. Throws SceneError if there is no such quantity, or no pair,
  /// support, obstacle or probe of that name.
  /// @param text the name
  /// @param place position in the scene, which precedes the message
  /// @param names that exist in the scene
  /// @param dim number of components of vectors
  /// @return its parts
  QuantityName
  read_quantity(const std::string   &text,
                const std::string   &place,
                const QuantityNames &names,
                int                  dim);

  /// Value and derivative of a quantity at a solution, (8.1).
  struct Functional
  {
    double value = 0;
    /// Derivative with respect to the free degrees of freedom.
    LA::Vector of_displacement;
    /// Derivative with respect to the coefficients of the volumetric stress of bodies in
    /// displacement-pressure form; empty: zero.
    LA::Vector of_volumetric_stress;
    /// Derivative with respect to the tractions at the contact points: the pressure, and with
    /// friction the components along the tangents.
    PointVectors of_traction;
    /// A displacement that is subtracted from the dual one, since the functional is written with
    /// it: that of a reaction is one on its support and zero elsewhere. Empty: none.
    LA::Vector lift;
    /// Whether the derivative is that of a smooth quantity close to this one, so that it describes
    /// the error approximately only.
    bool is_regularised = false;
    /// Recovered minus computed value of a quantity at a point, which has the derivative of the
    /// recovered one.
    double local = 0;
    /// Size of the error of the value by what is not resolved within a face, in its units.
    double unresolved = 0;
    /// Whether the exact value has no limit, so that there is no bound of its error.
    bool is_singular = false;
    /// Whether the quantity is the energy, see error_estimate().
    bool is_quadratic = false;
  };

  /// @return value and derivative of a quantity. Collective.
  /// @param name as read_quantity() has interpreted it
  /// @param snapshot the solution
  /// @param probes of the scene
  template <int dim>
  Functional
  functional(const QuantityName &name, const Snapshot<dim> &snapshot, const Probes<dim> &probes);
} // namespace Signorini
