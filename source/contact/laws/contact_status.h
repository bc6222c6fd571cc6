// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace Signorini
{
  /// The status of a contact point. Vectors over all points have these values. Without friction,
  /// closed points have the status slip.
  enum class ContactStatus
  {
    open  = 0,
    slip  = 1,
    stick = 2
  };

  /// True unless the point is open. @param status value of a ContactStatus
  inline bool
  is_closed(const double status)
  {
    return status > 0;
  }

  /// The status of a value in a vector over the points.
  inline ContactStatus
  status_of(const double value)
  {
    return static_cast<ContactStatus>(static_cast<int>(value + 0.5));
  }
} // namespace Signorini
