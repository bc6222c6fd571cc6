// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/constraints/gap_operator.h"
#include <signorini/contact/pair.h>

namespace Signorini
{
  /// The utilisation of the bonds that can fail, at all contact points: BondStrength::utilisation()
  /// where the bond is intact, zero elsewhere. It is intact where the points have at least the
  /// status stick.
  /// @param traction normal and tangential, per reference area
  template <int dim>
  LA::Vector
  bond_utilisation(const std::vector<ContactPair<dim>> &pairs,
                   const GapOperator                   &contact,
                   const PointVectors                  &traction);

  /// Let bonds fail after a solution: those whose utilisation is at least 1 and, to rounding, the
  /// largest one of all. The others are judged by the next solution, in which these are open.
  /// Collective.
  /// @param traction of the solution
  /// @param intact 1 where the bond is intact, else 0; changed
  /// @return whether any has failed
  template <int dim>
  bool
  break_bonds(const std::vector<ContactPair<dim>> &pairs,
              const GapOperator                   &contact,
              const PointVectors                  &traction,
              LA::Vector                          &intact);

  /// Let the points of tied pairs be intact or in contact. Places without strength become points in
  /// contact. Throws SceneError on all ranks where a strength is invalid. Collective.
  /// @param intact as of break_bonds(); values beyond a half are 1
  template <int dim>
  void
  set_bonds(const std::vector<ContactPair<dim>> &pairs, LA::Vector &intact, GapOperator &contact);

  /// How sharply a bond is loaded: the change of the utilisation across the face where it is
  /// largest, relative to that value, in [0,1]; among the intact points of one pair. Zero if there
  /// are none. Collective.
  /// @param utilisation bond_utilisation()
  double
  change_across_face(const GapOperator &contact, unsigned int pair, const LA::Vector &utilisation);
} // namespace Signorini
