#pragma once

#include <signorini/contact/gap_operator.h>

#include <memory>
#include <string>
#include <vector>

namespace Signorini
{
  /// How contact is imposed. All methods share one law at the contact points (pressure positive in
  /// compression, gap positive when open):
  ///
  ///   p = max(0, p^ - eps g),
  ///
  /// the active set being where the maximum is not zero. A method says only what p^ is, how large
  /// eps, and at which points the law holds: one file pair under contact/methods and one line in
  /// the registry.
  class ContactMethod
  {
  public:
    virtual ~ContactMethod() = default;

    /// The keys of the method's own section.
    virtual void
    declare(Section &section) = 0;

    virtual Sampling
    sampling() const = 0;

    /// True: the pressure is an unknown of its own, p^ = p, so that g = 0 where active; false: it
    /// follows from the gap.
    virtual bool
    has_multipliers() const = 0;

    /// Where the pressure is an unknown: the law is g + compliance p / (E/h) = 0 where active.
    virtual double
    compliance() const
    {
      return 0;
    }

    /// Where the pressure follows from the gap: true: p^ is the pressure of the last solution, and
    /// one solution follows the other until the gap is closed; false: p^ = 0.
    virtual bool
    augments() const
    {
      return false;
    }

    /// eps = factor * E/h: dimensionless, so that nothing depends on the units of the scene.
    virtual double
    factor() const = 0;

    /// `name` is one of method_names().
    static std::shared_ptr<ContactMethod>
    create(const std::string &name);
  };

  const std::vector<std::string> &
  method_names();

  /// The law above at all points. In: gap, and p^ (with multipliers: their pressure). Out: pressure
  /// (zero where inactive; may be the same vector as p^) and active (1 or 0). Returns the number of
  /// active points.
  unsigned int
  apply_contact_law(const ContactMethod &method,
                    const GapOperator   &contact,
                    const LA::Vector    &gap,
                    const LA::Vector    &predicted,
                    LA::Vector          &pressure,
                    LA::Vector          &active);

  /// How well the conditions of Hertz, Signorini and Moreau hold, thesis (11)-(13), at the contact
  /// points.
  struct ContactConditions
  {
    double penetration     = 0; ///< largest -g [length]
    double tension         = 0; ///< largest -p [stress]
    double complementarity = 0; ///< largest |p g| [force/length]
  };

  ContactConditions
  contact_conditions(const LA::Vector &gap, const LA::Vector &pressure);
} // namespace Signorini
