// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace Signorini
{
  namespace LA
  {
    /// Libraries for the factorisation of sparse matrices.
    enum class DirectLibrary
    {
      SparseLU, ///< that of Eigen, in the order of OrderedLU; on one rank only
      KLU,      ///< gathers the matrix on one rank
      MUMPS     ///< distributed
    };

    /// The name of a library, for messages and settings.
    std::string
    name_of(DirectLibrary library);
  } // namespace LA
} // namespace Signorini
