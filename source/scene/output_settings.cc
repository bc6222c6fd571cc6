#include <signorini/parameters/section.h>
#include <signorini/scene/output_settings.h>

namespace Signorini
{
  template <int dim>
  void
  OutputSettings<dim>::declare(Section &section)
  {
    section.add("Directory", directory, "where files go; empty: output/NAME-OF-THE-SCENE");
    section.add("VTU",
                vtu,
                "yes or no: write solution.pvd (bodies) and contact.pvd (contact surfaces)");
    section.add("Linear reference",
                linear_reference,
                "yes or no: solve without contact too, and compare: R of the seconds, W of the "
                "multigrid cycles");
    section.add(
      "Strict",
      strict,
      "yes or no: what the verdict on the answer warns of ends the run with exit code 3, as --strict does");
    section.add(
      "Checkpoint every steps",
      checkpoint_steps,
      "a checkpoint after so many load steps, and after each refinement; 0: not by steps");
    section.add("Checkpoint every minutes",
                checkpoint_minutes,
                "a checkpoint after the load step that ends so long after the last one; 0: not by "
                "time [minutes of wall time]",
                non_negative);
    section.add("Time limit",
                time_limit,
                "the run ends before this, with a checkpoint and exit code 5; 0: none [minutes of "
                "wall time since the program was started]",
                non_negative);
    section.add_named(
      "Probes",
      probes,
      "Points, or lines of points, whose values are reported: displacement and stress in bodies, pressure and gap on pairs.");
  }



  template struct OutputSettings<2>;
  template struct OutputSettings<3>;
} // namespace Signorini
