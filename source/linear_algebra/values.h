// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "linear_algebra/types.h"

namespace Signorini
{
  namespace LA
  {
    /// The elements that this rank owns, in a row, Vector::locally_owned_size() of them: access by
    /// global index costs ten times more, and is collective now and then. They belong to the
    /// vector.
    inline double *
    values_of(Vector &v)
    {
      return v.trilinos_vector()[0];
    }

    inline const double *
    values_of(const Vector &v)
    {
      return v.trilinos_vector()[0];
    }
  } // namespace LA
} // namespace Signorini
