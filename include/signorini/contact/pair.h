// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/contact/bond_strength.h>
#include <signorini/contact/contact_compliance.h>
#include <signorini/contact/master_image.h>
#include <signorini/contact/pretension.h>
#include <signorini/parameters/expression.h>
#include <signorini/parameters/time_span.h>

#include <deal.II/base/point.h>

#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace Signorini
{
  class CompiledFormula;
  class Section;

  /// The choice of the slave surface of a pair.
  enum class SideChoice
  {
    /// The surface that carries a stable pressure; the one named as slave if both do.
    automatic,
    as_named
  };

  /// The coefficient of Coulomb friction of a contact pair, and the largest shear stress that
  /// friction transmits.
  template <int dim>
  struct FrictionCoefficient
  {
    /// Formula of mu in the reference position, time, pressure, and slip: the length of the path
    /// over which a point has slipped before the load step [length].
    Formula mu = "0";
    /// Upper bound of the tangential traction [force/length^2].
    double limit = std::numeric_limits<double>::infinity();

    /// Declare the keys. Throws SceneError through the section for invalid formulas.
    void
    declare(Section &section);

    /// True if there is no friction: the formula is the constant zero.
    bool
    is_zero() const;

    /// True if the bound is not mu(x, t) p: by the pressure, the slip, or the limit.
    bool
    is_nonlinear() const;

    /// True if the coefficient depends on the slip before the load step.
    bool
    depends_on_slip() const;

    /// True if the coefficient depends on time.
    bool
    depends_on_time() const;

    /// True if the coefficient belongs to the material points of the slave: by their place, or by
    /// the slip that they have behind them.
    bool
    depends_on_points() const;

    /// @return the coefficient; not a number where it is negative.
    /// @param x position in the reference configuration
    /// @param t time
    /// @param pressure positive in compression
    /// @param slip path length before the load step
    double
    value(const dealii::Point<dim> &x, double t, double pressure, double slip) const;

    /// @return the bound of the tangential traction, min(mu p, limit).
    double
    bound(const dealii::Point<dim> &x, double t, double pressure, double slip) const;

  private:
    std::shared_ptr<const CompiledFormula> compiled; ///< null: zero
  };

  /// Two surfaces that may touch: the slave, where contact is integrated, and the master, which is
  /// the boundary of another body or an obstacle.
  template <int dim>
  struct ContactPair : TimeSpan
  {
    /// Name of the pair; BODY.BOUNDARY of the slave and of the master, or the name of an obstacle.
    std::string name, slave, master;
    std::string slave_location, master_location; ///< in the scene file
    /// Or "closed", "kept" (tied surfaces), or a formula of the place and time.
    Formula initial_gap = "from geometry";
    /// Gaps in the reference configuration up to this value, and penetrations, are closed [length];
    /// negative: none.
    double closes_below = -1;
    /// False: bilateral contact, g = 0 for either sign of the pressure.
    bool can_separate = true;
    /// The surfaces are glued: no gap and no slip, whatever the traction, or up to the strength of
    /// the bond. Then can_separate is false.
    bool is_tied = false;
    /// Tied surfaces that keep the gaps between them, whatever these are, without strain.
    bool                     keeps_gaps = false;
    Expression<dim>          interference{"1"}; ///< share of initial overlaps that counts at time t
    FrictionCoefficient<dim> friction;
    ContactCompliance        compliance;
    MasterImage<dim>         image;      ///< of the master, which the slave meets
    Pretension<dim>          pretension; ///< of tied surfaces that are a section through a bolt
    BondStrength<dim>        strength;   ///< of tied surfaces whose bond can fail
    /// Of tied surfaces: the slaves of pairs in contact. Nodes that they share with this slave have
    /// multipliers of contact alone: with both, the contact of two tied nodes would be one
    /// condition twice.
    std::vector<std::string> contact_slaves;
    /// Search radius [length]; 0: estimated by the program.
    double search_distance = 0;
    /// Directions along which the extents of the contact area are reported.
    std::vector<dealii::Point<dim>> directions;
    SideChoice                      sides = SideChoice::automatic;
    /// True if slave and master were exchanged: the scene names the present master as slave.
    bool exchanged = false;
    /// True if the program has found the pair; then it need not come into contact.
    bool found = false;
    /// Self-contact: sign of the direction of SelfContact along which the slave faces; the master
    /// faces the other way.
    double self_side = 1;

    /// Declare the keys of a pair in its section. Throws SceneError through the section for invalid
    /// combinations.
    void
    declare(Section &section);

    /// The part of declare() after reading the keys.
    void
    check_keys(Section &section);

    /// True if the reference gap is given by the input, not by the positions of the bodies.
    bool
    gap_is_given() const
    {
      return initial_gap.text != "from geometry" && !keeps_gaps;
    }

    /// True if the prescribed gap depends on time.
    bool
    gap_depends_on_time() const;

    /// True if the slave meets the master where that is.
    bool
    master_is_in_place() const
    {
      return image.is_master() && !pretension.given();
    }

    /// True if slave and master are the same surface, in self-contact.
    bool
    is_self() const
    {
      return slave == master;
    }

    /// Exchange slave and master.
    void
    exchange();

    /// The slave as the input names it, before any exchange.
    const std::string &
    named_slave() const
    {
      return exchanged ? master : slave;
    }
    /// The master as the input names it, before any exchange.
    const std::string &
    named_master() const
    {
      return exchanged ? slave : master;
    }
  };
} // namespace Signorini
