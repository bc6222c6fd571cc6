// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/constraints/gap_operator.h"

#include <vector>

namespace Signorini
{
  using namespace dealii;

  /// The trial traction of a law and its bound of friction; refers to both arguments.
  struct TrialFriction
  {
    const GapOperator  &contact;
    const PointVectors &trial;

    double
    bound(const types::global_dof_index i) const
    {
      return contact.coefficients.friction_bound(i, trial[0](i)).value;
    }

    /// The size of the tangential trial traction.
    double
    size(const types::global_dof_index i) const
    {
      return length_at(trial, i, 1);
    }

    /// A space component of the tangential trial traction.
    double
    in_space(const types::global_dof_index i, const unsigned int d) const
    {
      double sum = 0;
      for (unsigned int a = 1; a < trial.size(); ++a)
        sum += trial[a](i) * contact.tangential.direction[a - 1][d](i);
      return sum;
    }

    /// True if the tangential trial traction makes more than a right angle with a traction.
    bool
    is_against(const types::global_dof_index i, const PointVectors &traction) const
    {
      double product = 0;
      for (unsigned int a = 1; a < trial.size(); ++a)
        product += trial[a](i) * traction[a](i);
      return product < 0;
    }

    /// The component of the tangential trial traction along a direction in space.
    double
    along(const types::global_dof_index i, const std::vector<double> &direction) const
    {
      double sum = 0;
      for (unsigned int d = 0; d < direction.size(); ++d)
        sum += in_space(i, d) * direction[d];
      return sum;
    }
  };
} // namespace Signorini
