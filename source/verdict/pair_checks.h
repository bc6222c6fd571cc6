// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "verdict/checks.h"

#include <limits>

namespace Signorini
{
  /// Areas and extreme values of the contact of one pair, over all ranks.
  struct ContactExtent
  {
    /// Area of active points, and of all candidates.
    double active = 0, candidates = 0;
    /// Area and number of the faces that carry pressure.
    double touched_faces = 0, n_touched = 0;
    /// Smallest gap of the undeformed bodies [length].
    double smallest_reference_gap = std::numeric_limits<double>::max();
    /// Smallest cosine between the slave normal and the opposite master normal where there is
    /// pressure.
    double smallest_normal_alignment = 1;
    /// Mean penetration [length] over the active area.
    double penetration = 0;
    /// Largest overlap [length] at any integration point.
    double deepest = 0;
    // Extreme gaps of active points between the undeformed bodies:
    double largest_reference_gap = -std::numeric_limits<double>::max(),
           least_reference_gap   = -largest_reference_gap;
    /// Largest pressure, largest stiffness times depth (a modulus), and largest penalty.
    double pressure = 0, modulus = 0, epsilon = 0;
  };

  /// @return the extent of a pair. Collective.
  /// @param s the solution
  /// @param pair its number
  /// @param obstacle null if the master is a boundary of a body
  template <int dim>
  ContactExtent
  contact_extent_of(const Snapshot<dim> &s, unsigned int pair, const Obstacle<dim> *obstacle);

  /// The deepest penetration of an obstacle into a surface.
  struct ObstacleTip
  {
    /// Depth [length], and size [length] of the face where it is deepest.
    double depth = 0, face = 0;
  };

  /// @return the deepest penetration of an obstacle, which may be so small that it is between the
  /// integration points. Collective.
  /// @param obstacle of the pair
  /// @param s the solution
  /// @param surface name of the slave boundary
  template <int dim>
  ObstacleTip
  deepest_tip(const Obstacle<dim> &obstacle, const Snapshot<dim> &s, const std::string &surface);

  /// @return the checks of a pair with friction: tractions, work, and load steps of the path.
  /// @param name of the pair
  /// @param results its entry of results.json
  /// @param extent of the pair
  /// @param face_size mean size of the faces of the slave [length]
  /// @param step number of the load step
  std::vector<CheckResult>
  check_friction(const std::string            &name,
                 const nlohmann::ordered_json &results,
                 const ContactExtent          &extent,
                 double                        face_size,
                 unsigned int                  step);

  /// @return the check that nodes match, with a method that connects nodes with surfaces.
  /// @param name of the pair
  /// @param share_of_others share of the slave's area whose nodes do not coincide with master nodes
  CheckResult
  check_matching_nodes(const std::string &name, double share_of_others);

  /// @return the checks of a tied pair: whether the slave is tied as a whole, whether nodes match
  /// if they have to, the image of its master, and the resolution of a bond that can fail.
  /// Collective.
  /// @param now the solution
  /// @param pair its number
  /// @param needs_nodes whether the method connects nodes with surfaces
  /// @param results the entry of the pair in results.json
  template <int dim>
  std::vector<CheckResult>
  check_tie(const Snapshot<dim>          &now,
            unsigned int                  pair,
            bool                          needs_nodes,
            const nlohmann::ordered_json &results);

  /// @return the result of a check, of a pair or of the whole load step: passed up to the limit,
  /// otherwise a warning.
  /// @param check its name
  /// @param pair name of the pair; may be empty
  /// @param value what was measured
  /// @param limit largest value that passes
  /// @param message what is wrong otherwise
  /// @param advice what can be done about it
  CheckResult
  make_check_result(const std::string &check,
                    const std::string &pair,
                    double             value,
                    double             limit,
                    const std::string &message,
                    const std::string &advice);

  /// @return the check of the pressure for node-to-node oscillation: the share of nodes where it
  /// alternates by more than two percent of the largest pressure. Collective.
  /// @param s the solution
  /// @param pair its number
  /// @param extent of its contact
  template <int dim>
  CheckResult
  check_pressure_oscillation(const Snapshot<dim> &s,
                             unsigned int         pair,
                             const ContactExtent &extent);
} // namespace Signorini
