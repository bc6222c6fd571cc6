#pragma once

#include "contact/constraints/gap_operator.h"
#include "contact/laws/contact_status.h"
#include "solid/free_motion.h"

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
  /// and they are never in the residual. Along loose motions, the forces at work push the bodies
  /// until they touch something.
  class FreeMotions
  {
  public:
    FreeMotions() = default;

    /// @param springs S, a diagonal; positive wherever a motion is not zero
    FreeMotions(std::vector<FreeMotion> motions,
                const LA::Vector       &springs,
                const GapOperator      &contact);

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
    subtract_springs(LA::Vector &dst, const LA::Vector &src) const;

    /// dst += sum_z S z (S z).src, over loose motions
    void
    add_loose(LA::Vector &dst, const LA::Vector &src) const;

    /// Names of the motions that would be loose even if all contact points were closed, and stuck
    /// if they can.
    const std::vector<std::string> &
    never_held() const
    {
      return hopeless;
    }

    /// Names of the loose motions along which the forces r are not in balance, relative to a force
    /// (empty argument: of all). "ball: translation z"
    std::vector<std::string>
    loose() const;
    std::vector<std::string>
    driven(const LA::Vector &r, double scale) const;

    /// Take the part along loose motions out of the forces r, as a support would, where it is less
    /// than 1 % of what the contact forces on what moves add up to. Returns the largest such force.
    /// @param p tractions; of those of a pair that never separates, which may pull here and push
    /// there, the resultant counts
    double
    hold(LA::Vector &r, const PointVectors &p, const LA::Vector &stress) const;

    /// Move u along the loose motions, as r drives them, up to the first contact and a little
    /// further. Returns false if nothing stands in the way.
    bool
    close(LA::Vector &u, const LA::Vector &r) const;

  private:
    struct Loose
    {
      FreeMotion free;         ///< z
      LA::Vector spring_force; ///< S z
    };

    void
    orthonormalise_loose();
    /// Of points in the area of those of their pair that have at least that status: what is stiff
    /// does not matter beside what is soft.
    LA::Vector
    shares_of_pairs(const LA::Vector &status, ContactStatus least) const;

    std::vector<FreeMotion> motions; ///< orthonormal with respect to S
    LA::Vector              springs;
    const GapOperator      *contact = nullptr;
    /// B_a z, [component a][motion z].
    std::vector<std::vector<LA::Vector>> approach;
    std::vector<double>                  amplitude; ///< largest component of each motion
    std::vector<Loose>                   loose_motions;

    std::vector<std::string> hopeless;
  };
} // namespace Signorini
