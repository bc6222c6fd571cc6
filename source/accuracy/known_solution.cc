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
    section.add("Pressure",
                pressure,
                "contact pressure, likewise; written beside the computed one in profiles");
    section.add("Bulk stress", bulk_stress, "of mixed bodies, tension positive, likewise [stress]");
    if (!section.reading())
      return;
    for (const auto &[key, formula] :
         {std::pair<const char *, const Formula &>("Pressure", pressure),
          std::pair<const char *, const Formula &>("Bulk stress", bulk_stress)})
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
