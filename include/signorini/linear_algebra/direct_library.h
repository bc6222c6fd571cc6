// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace Signorini
{
  namespace LA
  {
    /// Who factorises sparse matrices.
    enum class DirectLibrary
    {
      KLU,  ///< gathers the matrix on one rank
      MUMPS ///< distributed
    };

    std::string
    name_of(DirectLibrary library);
  } // namespace LA
} // namespace Signorini
