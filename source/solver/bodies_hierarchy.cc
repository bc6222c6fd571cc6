#include "solver/bodies_hierarchy.h"

#include "multigrid/make_levels.h"
#include "solid/rigid_body_modes.h"

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    std::shared_ptr<const Hierarchy>
    make_hierarchy(const LinearSolverSettings &settings,
                   const Stiffness            &stiffness,
                   const Elasticity<dim>      &elasticity)
    {
      const auto known = [&](std::vector<std::vector<double>> &&modes) {
        if (settings.near_null_space == NearNullSpace::translations)
          modes.resize(dim); // they come first
        return std::move(modes);
      };
      Spaces spaces;
      if (settings.coarsening != Coarsening::algebraic)
        spaces = make_spaces(elasticity, stiffness, settings.coarsening != Coarsening::degree);
      const auto modes =
        known(spaces.levels.empty() ? rigid_body_modes(elasticity) : std::move(spaces.modes));
      return std::make_shared<const Hierarchy>(stiffness, std::move(spaces.levels), modes, dim);
    }
  } // namespace



  template <int d>
  BodiesHierarchy::BodiesHierarchy(const LinearSolverSettings &settings,
                                   const Stiffness            &stiffness,
                                   const Elasticity<d>        &elasticity)
    : BodiesHierarchy(stiffness, d)
  {
    if (settings.preconditioner != "direct")
      make = [settings, &stiffness, &elasticity] {
        return make_hierarchy(settings, stiffness, elasticity);
      };
  }



  BodiesHierarchy::BodiesHierarchy(const Stiffness                                  &stiffness,
                                   const unsigned int                                dim,
                                   std::function<std::shared_ptr<const Hierarchy>()> make)
    : stiffness(stiffness)
    , my_dim(dim)
    , make(std::move(make))
  {}



  std::shared_ptr<const Hierarchy>
  BodiesHierarchy::get()
  {
    const bool is_made = hierarchy && hierarchy->n_levels() > 1; // else it is the matrix itself
    if (!make || version == stiffness.version() || (is_made && !is_worn))
      return hierarchy;
    hierarchy.reset(); // before there are two
    hierarchy = make();
    version   = stiffness.version();
    is_worn   = false;
    at_first  = 0;
    return hierarchy;
  }



  void
  BodiesHierarchy::judge(const double iterations_per_digit)
  {
    constexpr double much = 1.5, some = 1; // half as many again cost about what it takes to make it
    if (at_first == 0)
      at_first = iterations_per_digit;
    else
      is_worn = is_worn || iterations_per_digit > much * at_first + some;
  }



  bool
  BodiesHierarchy::renew()
  {
    if (!hierarchy || version == stiffness.version())
      return false;
    is_worn = true;
    return true;
  }



  template BodiesHierarchy::BodiesHierarchy(const LinearSolverSettings &,
                                            const Stiffness &,
                                            const Elasticity<2> &);
  template BodiesHierarchy::BodiesHierarchy(const LinearSolverSettings &,
                                            const Stiffness &,
                                            const Elasticity<3> &);
} // namespace Signorini
