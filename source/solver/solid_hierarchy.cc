// SPDX-License-Identifier: Apache-2.0
#include "solver/solid_hierarchy.h"

#include "linear_algebra/smoothed_aggregation.h"
#include "multigrid/levels.h"
#include "solid/rigid_body_modes.h"

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The levels of a stiffness: spaces of displacements as far as the settings allow them, then
    /// aggregates with the rigid-body modes of the last space. Collective.
    template <int dim>
    std::shared_ptr<const Hierarchy>
    make_hierarchy(const LinearSolverSettings &settings,
                   const Stiffness            &stiffness,
                   const Elasticity<dim>      &elasticity)
    {
      Spaces spaces;
      if (settings.coarsening != Coarsening::algebraic)
        spaces = make_spaces(elasticity, stiffness, settings.coarsening != Coarsening::degree);
      std::vector<std::vector<double>> modes;
      if (spaces.levels.empty() || spaces.levels.back().matrix->m() > LA::factorised_size)
        modes = rigid_body_modes(spaces.levels.empty() ? node_positions(elasticity) : spaces.nodes,
                                 elasticity.mesh().extent());
      if (settings.near_null_space == NearNullSpace::translations)
        // Translations come first.
        modes.resize(dim);
      return std::make_shared<const Hierarchy>(stiffness, std::move(spaces.levels), modes, dim);
    }
  } // namespace



  template <int d>
  SolidHierarchy::SolidHierarchy(const LinearSolverSettings &settings,
                                 const Stiffness            &stiffness,
                                 const Elasticity<d>        &elasticity)
    : SolidHierarchy(stiffness, d)
  {
    if (settings.traits().uses_hierarchy)
      make = [settings, &stiffness, &elasticity] {
        return make_hierarchy(settings, stiffness, elasticity);
      };
  }



  SolidHierarchy::SolidHierarchy(const Stiffness                                  &stiffness,
                                 const unsigned int                                dim,
                                 std::function<std::shared_ptr<const Hierarchy>()> make)
    : stiffness(stiffness)
    , my_dim(dim)
    , make(std::move(make))
  {}



  // A hierarchy whose finest level is separate from the coarser ones is kept when the stiffness
  // changes, until record_iterations() indicates that it no longer fits.
  std::shared_ptr<const Hierarchy>
  SolidHierarchy::get()
  {
    const bool is_inserted = hierarchy && hierarchy->n_levels() > 1;
    if (!make || version == stiffness.version() || (is_inserted && !needs_rebuild))
      return hierarchy;
    // The former one is released first, so that memory is not needed twice.
    hierarchy.reset();
    hierarchy                  = make();
    version                    = stiffness.version();
    needs_rebuild              = false;
    first_iterations_per_digit = 0;
    return hierarchy;
  }



  // Rebuilding costs about as much as half as many iterations again, hence the factor of 1.5.
  void
  SolidHierarchy::record_iterations(const double iterations_per_digit)
  {
    constexpr double much = 1.5, some = 1;
    if (first_iterations_per_digit == 0)
      first_iterations_per_digit = iterations_per_digit;
    else
      needs_rebuild =
        needs_rebuild || iterations_per_digit > much * first_iterations_per_digit + some;
  }



  bool
  SolidHierarchy::request_rebuild()
  {
    if (!hierarchy || version == stiffness.version())
      return false;
    needs_rebuild = true;
    return true;
  }



  template SolidHierarchy::SolidHierarchy(const LinearSolverSettings &,
                                          const Stiffness &,
                                          const Elasticity<2> &);
  template SolidHierarchy::SolidHierarchy(const LinearSolverSettings &,
                                          const Stiffness &,
                                          const Elasticity<3> &);
} // namespace Signorini
