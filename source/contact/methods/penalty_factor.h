// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/contact/methods/method.h>

namespace Signorini
{
  class Section;

  /// A penalty, as a multiple of E/h or as an absolute value [force/length^3].
  struct PenaltyFactor
  {
    double factor    = 1000; ///< of E/h
    double stiffness = 0;    ///< [force/length^3]; 0: the factor counts

    /// The keys `Factor`, whose help is given, and `Stiffness`; throws SceneError if both are set.
    void
    declare(Section &section, const std::string &help);

    /// True if the penalty is given as an absolute value.
    bool
    is_absolute() const
    {
      return stiffness > 0;
    }

    /// The penalty eps at a contact point [force/length^3].
    double
    of(const PenaltyScale &scale) const
    {
      return is_absolute() ? stiffness : factor * scale.stiffness;
    }
  };
} // namespace Signorini
