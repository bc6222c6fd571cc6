// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/contact/methods/method.h>

namespace Signorini
{
  class Section;

  /// How stiff a penalty is: in units of E/h, or absolute.
  struct PenaltyFactor
  {
    double factor    = 1000; ///< of E/h
    double stiffness = 0;    ///< [force/length^3]; 0: the factor counts

    /// The keys `Factor`, whose help is given, and `Stiffness`; throws SceneError if both are set.
    void
    declare(Section &section, const std::string &help);

    bool
    is_absolute() const
    {
      return stiffness > 0;
    }

    /// eps
    double
    of(const PenaltyScale &scale) const
    {
      return is_absolute() ? stiffness : factor * scale.stiffness;
    }
  };
} // namespace Signorini
