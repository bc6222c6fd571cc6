// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace Signorini
{
  /// What a contact point does. Vectors at all points have these values. A closed point without
  /// friction slips.
  enum class ContactStatus
  {
    open  = 0,
    slip  = 1,
    stick = 2
  };

  /// @param status value of a ContactStatus
  inline bool
  is_closed(const double status)
  {
    return status > 0;
  }

  inline ContactStatus
  status_of(const double value)
  {
    return static_cast<ContactStatus>(static_cast<int>(value + 0.5));
  }
} // namespace Signorini
