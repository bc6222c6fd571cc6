// SPDX-License-Identifier: Apache-2.0
#include <signorini/parameters/section.h>
#include <signorini/scene/output_settings.h>

namespace Signorini
{
  template <int dim>
  void
  OutputSettings<dim>::declare(Section &section)
  {
    section.add("Directory", directory, "output directory; empty: output/NAME-OF-THE-SCENE");
    section.add("VTU",
                vtu,
                "yes or no: write solution.pvd (bodies) and contact.pvd (contact surfaces)");
    section.add(
      "Strain",
      strain,
      "yes or no: solution.pvd has the strain too: the linear one, or at finite strain the "
      "logarithmic one ln V");
    section.add(
      "Linear reference",
      linear_reference,
      "yes or no: solve the bodies without contact too, and report the ratios of the seconds and "
      "of the multigrid cycles");
    section.add(
      "Strict",
      strict,
      "yes or no: warnings of the verdict end the run with exit code 3, as with --strict");
    section.rename_key("Checkpoint every steps", "Steps between checkpoints");
    section.add("Steps between checkpoints",
                checkpoint_steps,
                "number of load steps between checkpoints, which are also written after each "
                "refinement; 0: not by number of steps");
    section.rename_key("Checkpoint every minutes", "Minutes between checkpoints");
    section.add(
      "Minutes between checkpoints",
      checkpoint_minutes,
      "least time between checkpoints, which are written at the end of a load step; 0: not "
      "by time [minutes of wall time]",
      non_negative);
    section.add(
      "Keep checkpoint",
      keep_checkpoint,
      "yes or no: keep the last checkpoint of a finished run, from which --restart with a "
      "later Load steps/End time continues, with other loads and supports");
    section.add(
      "Time limit",
      time_limit,
      "the run ends before this time with a checkpoint and exit code 5; 0: none [minutes of "
      "wall time since the program was started]",
      non_negative);
    section.add_named(
      "Probes",
      probes,
      "Points, or lines of points, at which displacement and stress in bodies, or pressure and gap on contact pairs are reported.");
    section.add_named(
      "Cross sections",
      cross_sections,
      "Planes through bodies across which force and moment are reported, as of bolts and beams.");
  }



  template struct OutputSettings<2>;
  template struct OutputSettings<3>;
} // namespace Signorini
