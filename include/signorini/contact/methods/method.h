// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/contact/methods/integration.h>

#include <memory>
#include <string>
#include <vector>

namespace Signorini
{
  class ContactLaw;
  struct GapOperator;
  class Section;

  /// Where a method imposes contact.
  enum class Sampling
  {
    /// The law holds at each quadrature point.
    quadrature_points,
    /// The law holds for gaps weighted with the multiplier functions of the slave nodes (mortar).
    nodes
  };

  /// The pressure p^ by which the contact law p = max(0, p^ - eps g) is shifted.
  enum class PressureShift
  {
    none,       ///< p^ = 0
    multiplier, ///< the pressure itself, an unknown
    /// The pressure of the last solution, updated until the gap is closed (Uzawa).
    last_pressure,
    /// The normal stress of the bodies at the contact point (Nitsche).
    normal_stress
  };

  /// The scales of the penalty parameter at a contact point.
  struct PenaltyScale
  {
    double stiffness; ///< E/h of slave and master in series [force/length^3]
    double fineness;  ///< L/h: size of the scene over the depth of the slave's cell
    double bound;     ///< of the normal stress, see NormalStress::bound() [force/length^3]
  };

  /// A contact method. It makes the contact law; for all methods that is p = max(0, p^ - eps g),
  /// see NormalContact, and with friction t = Pi(t^ - eps s) upon it, see CoulombFriction, so that
  /// a method only chooses p^ and t^, eps and the points at which the law holds (doc/theory, 2.1).
  /// A method is a file in contact/methods, its declaration in methods.h, and a line in the
  /// registry.
  class ContactMethod
  {
  public:
    virtual ~ContactMethod() = default;

    /// Declare the keys of the method's own section.
    virtual void
    declare(Section &section) = 0;

    /// The points at which the law holds.
    virtual Sampling
    sampling() const = 0;

    /// The choice of p^.
    virtual PressureShift
    pressure_shift() const = 0;

    /// True if the pressure is an independent unknown, for which the law is an equation: g = 0 on
    /// active points if p^ is the pressure itself, else g + p/eps = 0. False if the pressure
    /// follows from the law.
    virtual bool
    has_multipliers() const = 0;

    /// The penalty parameter eps [force/length^3]: a dimensionless factor times one of the scales,
    /// so that nothing depends on the units of the scene, or an absolute value.
    virtual double
    penalty(const PenaltyScale &scale) const = 0;

    /// Make the contact law, which keeps a reference to the gap operator.
    virtual std::unique_ptr<ContactLaw>
    make_law(const GapOperator &contact) const;

    /// Whether any pair of the scene has friction, whether any is tied, and whether any tied one
    /// can fail, or begins after the start of the history, which the scene tells its methods.
    bool has_friction = false, has_ties = false, has_strength = false, has_late_ties = false;

    /// True if the law depends on the slip; then contact points have as many components as the
    /// dimension.
    virtual bool
    uses_slip() const
    {
      return has_friction || has_ties;
    }

    /// True if tractions depend on earlier load steps, by internal variables of the law or by the
    /// slip, which is measured from the end of the last load step.
    virtual bool
    is_path_dependent() const
    {
      return uses_slip();
    }

    /// The parameter theta of Nitsche's method (doc/theory, (2.14)): 1, 0 or -1; 0 for other
    /// methods.
    virtual double
    theta() const
    {
      return 0;
    }

    /// True for the unbiased form: each surface of a pair is slave of the other with half of the
    /// weight.
    virtual bool
    unbiased() const
    {
      return false;
    }

    /// The integration rule that is used if none is given.
    virtual Rule
    usual_integration() const
    {
      return Rule::segments;
    }

    /// Throws SceneError if the method cannot be combined with the integration; the message begins
    /// with "Contact method".
    /// @param degree of the displacement of the slave
    virtual void
    check([[maybe_unused]] const Integration &integration,
          [[maybe_unused]] unsigned int       degree) const
    {}

    /// Make a method. @param name one of method_names()
    static std::shared_ptr<ContactMethod>
    create(const std::string &name);
  };

  /// The names of all methods, for the key Contact method/Method.
  const std::vector<std::string> &
  method_names();
} // namespace Signorini
