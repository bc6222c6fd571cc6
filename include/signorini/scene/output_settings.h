// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/fields/cross_section.h>
#include <signorini/fields/probe.h>

#include <string>
#include <vector>

namespace Signorini
{
  /// The files of a run, in addition to results.json.
  template <int dim>
  struct OutputSettings
  {
    /// Output directory; empty: output/ and the name of the scene.
    std::string directory;
    bool        vtu = true;
    /// Whether the VTU files of bodies have strains.
    bool strain           = false;
    bool linear_reference = false;
    /// Whether warnings of the verdict are failures.
    bool strict = false;
    /// Number of load steps between checkpoints; 0: not by steps.
    unsigned int checkpoint_steps = 0;
    /// Time between checkpoints [minutes of wall time]; 0: not by time.
    double checkpoint_minutes = 10;
    /// Whether the last checkpoint of a finished run is kept, for further load steps.
    bool keep_checkpoint = false;
    /// Limit of the run [minutes of wall time]; 0: none.
    double                         time_limit = 0;
    std::vector<Probe<dim>>        probes;
    std::vector<CrossSection<dim>> cross_sections;

    /// Declare the keys and read their values. Throws SceneError.
    /// @param section `Output`
    void
    declare(Section &section);
  };
} // namespace Signorini
