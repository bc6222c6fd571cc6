// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fields/snapshot.h"
#include <signorini/fields/probe.h>

#include <string>
#include <vector>

namespace Signorini
{
  /// What a user wants to know, in words: "WHAT [COMPONENT] of NAME", as "force of interface",
  /// "force y of interface", "reaction of base", "stress xx of tip"; or "energy".
  struct QuantityName
  {
    std::string text;
    std::string what;      ///< "force"
    std::string component; ///< "y", or empty
    std::string of;        ///< a pair, support, obstacle or probe; or empty
  };

  /// The names of what quantities can be of.
  struct QuantityNames
  {
    std::vector<std::string> pairs, supports, obstacles;
    std::vector<std::string> probes;         ///< points in bodies
    std::vector<std::string> surface_probes; ///< points on pairs
  };

  /// Throws SceneError, with `place` before the message, if there is no such quantity, or if the
  /// names have not what it is of.
  /// @param dim components
  QuantityName
  read_quantity(const std::string   &text,
                const std::string   &place,
                const QuantityNames &names,
                int                  dim);

  /// Value and derivative of a quantity at a solution.
  struct Functional
  {
    double     value = 0;
    LA::Vector of_displacement; ///< derivative by the free degrees of freedom
    LA::Vector of_pressure;     ///< by the pressures at the contact points
    /// A displacement that the dual one shall be without, since the functional is written with it:
    /// that of a reaction is one on its support and zero elsewhere. Empty: none.
    LA::Vector lift;
    /// The derivative is that of a smooth quantity close to this one, so that it tells the error
    /// about only.
    bool   is_regularised = false;
    double unresolved     = 0;     ///< by what the value may be wrong within a face
    bool   is_quadratic   = false; ///< the energy, see error_estimate()
  };

  /// Collective.
  template <int dim>
  Functional
  functional(const QuantityName &name, const Snapshot<dim> &snapshot, const Probes<dim> &probes);
} // namespace Signorini
