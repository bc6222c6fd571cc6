#pragma once

#include <signorini/elasticity/elasticity.h>

#include <vector>

namespace Signorini
{
  struct RefinementSettings
  {
    /// Which cells are refined.
    enum class Strategy
    {
      estimator, ///< where stress jumps most
      global     ///< all
    };

    unsigned int cycles           = 0;
    Strategy     strategy         = Strategy::estimator;
    double       refine_fraction  = 0.15;
    double       coarsen_fraction = 0.03;
    unsigned int maximum_cells    = 10000000;
    double       tolerance        = 1e-4; ///< of Newton's method on all meshes but the last

    void
    declare(Section &section);
  };

  /// Refine the mesh, set the degrees of freedom up again, and carry vectors over: each goes in as
  /// it was and comes out interpolated. Strategy::estimator refines where jumps of stress
  /// between cells are largest (Kelly, Gago, Zienkiewicz, Babuska 1983, weighted by the energy of
  /// each body's material). Returns the estimated error of the old solution in the energy norm, up
  /// to a constant.
  template <int dim>
  double
  refine(const RefinementSettings        &settings,
         Mesh<dim>                       &mesh,
         Elasticity<dim>                 &elasticity,
         const LA::Vector                &displacement,
         const std::vector<LA::Vector *> &vectors);
} // namespace Signorini
