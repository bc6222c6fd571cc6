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
    quadrature_points, ///< point-wise
    nodes              ///< weighted with the pressure's functions of the slave (mortar)
  };

  /// The pressure p^ by which the contact law p = max(0, p^ - eps g) is shifted.
  enum class PressureShift
  {
    none,          ///< p^ = 0
    multiplier,    ///< the pressure itself, an unknown
    last_pressure, ///< that of the last solution: one follows the other until the gap is closed
    normal_stress  ///< that of the bodies at the contact point
  };

  /// The scales at a contact point that a penalty may be a multiple of.
  struct PenaltyScale
  {
    double stiffness; ///< E/h of slave and master in series [force/length^3]
    double fineness;  ///< L/h: size of the scene over the depth of the slave's cell
    double bound;     ///< of the normal stress, see NormalStress::bound() [force/length^3]
  };

  /// A contact method. It makes the contact law; for all methods without friction that is p =
  /// max(0, p^ - eps g), see NormalContact, and the method only chooses p^, eps and the points at
  /// which the law holds. A method is one file pair under contact/methods and one line in the
  /// registry.
  class ContactMethod
  {
  public:
    virtual ~ContactMethod() = default;

    /// Declare the keys of the method's own section.
    virtual void
    declare(Section &section) = 0;

    virtual Sampling
    sampling() const = 0;

    virtual PressureShift
    pressure_shift() const = 0;

    /// True: the pressure is an unknown of its own, and the law an equation for it: g = 0 where
    /// active if it is its own predictor, else g + p/eps = 0. False: it follows from the law.
    virtual bool
    has_multipliers() const = 0;

    /// eps: a dimensionless number times one of the scales, so that nothing depends on the units of
    /// the scene.
    virtual double
    penalty(const PenaltyScale &scale) const = 0;

    /// Make the contact law, which keeps a reference to the gap operator.
    virtual std::unique_ptr<ContactLaw>
    make_law(const GapOperator &contact) const;

    /// True if the law depends on the slip; then contact points have as many components as the
    /// dimension.
    virtual bool
    uses_slip() const
    {
      return false;
    }

    /// True: tractions depend on the load steps before, by internal variables of the law or by the
    /// slip, which counts from the end of the last one.
    virtual bool
    is_path_dependent() const
    {
      return uses_slip();
    }

    /// Nitsche's method: weight of the normal stress of virtual displacements.
    virtual double
    theta() const
    {
      return 0;
    }

    /// True: either surface of a pair is slave to the other, with half the weight.
    virtual bool
    unbiased() const
    {
      return false;
    }

    /// The rule of integration that serves the method best.
    virtual Rule
    usual_integration() const
    {
      return Rule::segments;
    }

    /// Throws SceneError where method and integration do not go together. The method's place in the
    /// scene file is "Contact method".
    virtual void
    check(const Integration & /*integration*/, unsigned int /*degree*/) const
    {}

    /// `name` is one of method_names().
    static std::shared_ptr<ContactMethod>
    create(const std::string &name);
  };

  const std::vector<std::string> &
  method_names();
} // namespace Signorini
