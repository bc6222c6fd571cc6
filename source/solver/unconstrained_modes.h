// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/constraints/gap_operator.h"
#include "contact/laws/contact_status.h"
#include "solid/unconstrained_mode.h"

#include <string>
#include <vector>

namespace Signorini
{
  /// Motions without deformation that no support stops: contact has to. K has no stiffness against
  /// them but springs S, which make it regular and have no part in the solution. What the active
  /// points stop needs no springs, so that they are taken out of the linear systems again, up to
  /// those along the motions z that are loose,
  ///
  ///   K - S + sum_z S z (S z)^T   with z^T S z' = delta_zz',
  ///
  /// and they are never in the residual. Along unconstrained modes, the forces at work push the
  /// bodies until they touch something.
  class UnconstrainedModes
  {
  public:
    UnconstrainedModes() = default;

    /// @param stabilisation S, a diagonal; positive wherever a motion is not zero
    UnconstrainedModes(std::vector<UnconstrainedMode> motions,
                       const LA::Vector              &stabilisation,
                       const GapOperator             &contact);

    bool
    empty() const
    {
      return motions.empty();
    }

    /// Find out which motions contact leaves loose: closed points stop what opens or overlaps them,
    /// those that stick stop slip too. Collective.
    void
    set_status(const LA::Vector &status);

    /// dst -= S src
    void
    subtract_stabilisation(LA::Vector &dst, const LA::Vector &src) const;

    /// dst += sum_z S z (S z).src, over unconstrained modes
    void
    add_unconstrained_stiffness(LA::Vector &dst, const LA::Vector &src) const;

    /// Names of the motions that would be loose even if all contact points were closed, and stuck
    /// if they can.
    const std::vector<std::string> &
    unconstrainable() const
    {
      return my_unconstrainable;
    }

    /// Names of the unconstrained modes along which the forces r are not in balance, relative to a
    /// force (empty argument: of all). "ball: translation z"
    std::vector<std::string>
    unconstrained() const;
    std::vector<std::string>
    loaded(const LA::Vector &r, double scale) const;

    /// Take the part along unconstrained modes out of the forces r, as a support would, where it is
    /// less than 1 % of what the contact forces on what moves add up to. Returns the largest such
    /// force.
    /// @param p tractions; of those of a pair that never separates, which may pull here and push
    /// there, the resultant counts
    double
    project_out(LA::Vector &r, const PointVectors &p, const LA::Vector &stress) const;

    /// Move u along the unconstrained modes, as r drives them, up to the first contact and a little
    /// further. Returns false if nothing stands in the way.
    bool
    move_into_contact(LA::Vector &u, const LA::Vector &r) const;

  private:
    struct UnconstrainedPart
    {
      UnconstrainedMode free;              ///< z
      LA::Vector        stabilising_force; ///< S z
    };

    void
    orthonormalise_unconstrained();
    /// Of points in the area of those of their pair that have at least that status: what is stiff
    /// does not matter beside what is soft.
    LA::Vector
    shares_of_pairs(const LA::Vector &status, ContactStatus least) const;

    std::vector<UnconstrainedMode> motions; ///< orthonormal with respect to S
    LA::Vector                     stabilisation;
    const GapOperator             *contact = nullptr;
    /// B_a z, [component a][motion z].
    std::vector<std::vector<LA::Vector>> gap_rates;
    std::vector<double>                  amplitude; ///< largest component of each motion
    std::vector<UnconstrainedPart>       my_unconstrained;

    std::vector<std::string> my_unconstrainable;
  };
} // namespace Signorini
