// SPDX-License-Identifier: Apache-2.0
#include <signorini/accuracy/known_solution.h>
#include <signorini/parameters/section.h>

namespace Signorini
{
  template <int dim>
  void
  KnownSolution<dim>::declare(Section &section)
  {
    section.add("Displacement",
                displacement,
                "formula of the coordinates and t; its errors are reported");
    section.add(
      "Pressure",
      pressure,
      "formula for the contact pressure; its errors are reported, and profiles contain it as reference");
    section.rename_key("Bulk stress", "Volumetric stress");
    section.add(
      "Volumetric stress",
      volumetric_stress,
      "formula for the volumetric stress of bodies with Formulation = mixed, tension positive; its "
      "error is reported [stress]");
    if (!section.reading())
      return;
    for (const auto &[key, formula] :
         {std::pair<const char *, const Formula &>("Pressure", pressure),
          std::pair<const char *, const Formula &>("Volumetric stress", volumetric_stress)})
      if (!formula.empty())
        try
          {
            Expression<dim>{formula};
          }
        catch (const SceneError &error)
          {
            section.fail(key, error.what());
          }
  }



  template struct KnownSolution<2>;
  template struct KnownSolution<3>;
} // namespace Signorini
