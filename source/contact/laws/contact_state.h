// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/constraints/gap_operator.h"
#include "contact/laws/contact_status.h"

namespace Signorini
{
  /// The internal variables of a contact law at all points.
  struct InternalFields
  {
    std::vector<PointVectors> vectors; ///< [k][a]: of variable k, component a along the tangents
    /// One vector for each variable.
    PointVectors scalars;

    bool
    empty() const
    {
      return vectors.empty() && scalars.empty();
    }

    /// To be called after entries were set. Collective.
    void
    compress()
    {
      for (PointVectors &variable : vectors)
        for (LA::Vector &component : variable)
          component.compress(dealii::VectorOperation::insert);
      for (LA::Vector &variable : scalars)
        variable.compress(dealii::VectorOperation::insert);
    }
  };

  /// The state of contact at the points of a gap operator.
  struct ContactState
  {
    /// Contact pressure, positive in compression, and tangential traction on the slave
    /// [force/length^2].
    PointVectors traction;
    LA::Vector   status; ///< values of ContactStatus
    /// Internal variables at the end of the last load step, and of the present one if it is solved;
    /// empty if the contact law has none.
    InternalFields internal, internal_at_end;

    /// The normal component of the traction.
    const LA::Vector &
    pressure() const
    {
      return traction[0];
    }
  };

  /// A state in which all points are open, without tractions and internal variables.
  inline ContactState
  open_contact(const GapOperator &contact)
  {
    return {contact.zeros(), contact.zero(), {}, {}};
  }

  /// Indicator of closed points: 1 at closed points, else 0.
  inline LA::Vector
  closed_points(const LA::Vector &status)
  {
    LA::Vector result = status;
    for (const auto i : status.locally_owned_elements())
      result(i) = is_closed(status(i)) ? 1. : 0.;
    result.compress(dealii::VectorOperation::insert);
    return result;
  }

  /// Convert an unknown q of the linear system [length] to the traction: multiply it by E/h at
  /// closed points, and set it to zero at open ones. Derivatives by tractions become derivatives by
  /// unknowns in the same way.
  inline void
  to_traction(const GapOperator &contact, const LA::Vector &status, LA::Vector &q)
  {
    q.scale(contact.coefficients.stiffness);
    q.scale(closed_points(status));
  }
} // namespace Signorini
