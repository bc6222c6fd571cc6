// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "linear_algebra/types.h"

namespace Signorini
{
  namespace LA
  {
    /// The owned elements of a vector as an array of Vector::locally_owned_size() entries, which
    /// belongs to the vector. Access by global index costs ten times more, and is sometimes
    /// collective.
    inline double *
    values_of(Vector &v)
    {
      return v.trilinos_vector()[0];
    }

    /// The same array of a vector that is not changed.
    inline const double *
    values_of(const Vector &v)
    {
      return v.trilinos_vector()[0];
    }
  } // namespace LA
} // namespace Signorini
