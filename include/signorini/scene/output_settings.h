// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/fields/probe.h>

#include <string>
#include <vector>

namespace Signorini
{
  /// What a run leaves behind, apart from the results file.
  template <int dim>
  struct OutputSettings
  {
    std::string             directory; ///< empty: output/ and the name of the scene
    bool                    vtu                = true;
    bool                    linear_reference   = false;
    bool                    strict             = false; ///< warnings of the verdict are failures
    unsigned int            checkpoint_steps   = 0;  ///< every so many load steps; 0: not by steps
    double                  checkpoint_minutes = 10; ///< of wall time; 0: not by time
    double                  time_limit         = 0;  ///< minutes of wall time; 0: none
    std::vector<Probe<dim>> probes;

    void
    declare(Section &section);
  };
} // namespace Signorini
