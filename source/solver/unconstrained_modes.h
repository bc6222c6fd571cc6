// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/constraints/gap_operator.h"
#include "contact/laws/contact_status.h"
#include "solid/unconstrained_mode.h"

#include <string>
#include <vector>

namespace Signorini
{
  /// Rigid-body modes that no support constrains, so that contact has to. K is stabilised along
  /// them by a diagonal S, which makes it regular and has no part in the solution. Modes that
  /// active points constrain need no stabilisation; the linear systems therefore contain it only
  /// along the unconstrained modes z,
  ///
  ///   K - S + sum_z S z (S z)^T   with z^T S z' = delta_zz',
  ///
  /// and the residual never contains it. Along unconstrained modes, the acting forces push the
  /// bodies until they touch something.
  class UnconstrainedModes
  {
  public:
    UnconstrainedModes() = default;

    /// Keeps a reference to `contact`.
    /// @param stabilisation the diagonal S; positive wherever a mode is not zero
    UnconstrainedModes(std::vector<UnconstrainedMode> motions,
                       const LA::Vector              &stabilisation,
                       const GapOperator             &contact);

    /// True if supports constrain all rigid-body modes, so that there is nothing to be done.
    bool
    empty() const
    {
      return motions.empty();
    }

    /// Determine which modes contact leaves unconstrained: closed points constrain the normal gap,
    /// sticking ones also the slip, and in space slipping ones with friction the slip across their
    /// traction, which a change of direction opposes. Collective.
    /// @param traction whose tangential part has that direction; empty: unknown
    void
    set_status(const LA::Vector &status, const PointVectors &traction = {});

    /// dst -= S src
    void
    subtract_stabilisation(LA::Vector &dst, const LA::Vector &src) const;

    /// dst += sum_z S z (S z).src over the unconstrained modes
    void
    add_unconstrained_stiffness(LA::Vector &dst, const LA::Vector &src) const;

    /// Names of the modes that would be unconstrained even if all contact points were closed, and
    /// stuck if the law allows that.
    const std::vector<std::string> &
    unconstrainable() const
    {
      return my_unconstrainable;
    }

    /// Names of the unconstrained modes, such as "ball: translation z".
    std::vector<std::string>
    unconstrained() const;
    /// Names of the unconstrained modes along which the forces r are not in equilibrium.
    /// Collective.
    /// @param scale force below which a mode counts as unloaded, relative to its largest
    /// displacement
    std::vector<std::string>
    loaded(const LA::Vector &r, double scale) const;

    /// Project the unconstrained modes out of the forces r, as a support would, where that part is
    /// less than 1 % of the sum of the contact forces on the moving bodies. Returns the largest
    /// force removed. Collective.
    /// @param p tractions; for pairs without separation, which may pull at some points and push at
    /// others, the resultant counts
    double
    project_out(LA::Vector &r, const PointVectors &p, const PointVectors &stress) const;

    /// Move u along the unconstrained modes, in the direction of the forces r, up to the first
    /// contact and a little further. Returns false if there is no contact in that direction.
    /// Collective.
    bool
    move_into_contact(LA::Vector &u, const LA::Vector &r) const;

  private:
    struct UnconstrainedPart
    {
      UnconstrainedMode free;              ///< z
      LA::Vector        stabilising_force; ///< S z
    };

    /// Make the unconstrained modes orthonormal with respect to S among each other.
    void
    orthonormalise_unconstrained();
    /// The share of each point in the area of those points of its pair that have at least the given
    /// status, so that stiff pairs do not outweigh soft ones.
    LA::Vector
    shares_of_pairs(const LA::Vector &status, ContactStatus least) const;
    /// The rates of the slip across the tangential traction, one vector for each motion; zero where
    /// there is no friction.
    std::vector<LA::Vector>
    rates_across(const PointVectors &traction) const;

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
