// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/elasticity.h"
#include "solver/preconditioners/hierarchy.h"
#include <signorini/solver/linear_solver_settings.h>

#include <functional>
#include <memory>

namespace Signorini
{
  /// The multigrid hierarchy of the bodies' stiffness, made when it is first asked for. Outlives
  /// contact that is looked for again. Where the stiffness changes, its finest level follows; the
  /// others do when iterations say that they no longer know what is smooth.
  class SolidHierarchy
  {
  public:
    /// Refers to stiffness and elasticity.
    template <int d>
    SolidHierarchy(const LinearSolverSettings &settings,
                   const Stiffness            &stiffness,
                   const Elasticity<d>        &elasticity);

    /// @param dim components of a node
    /// @param make empty: there is none
    SolidHierarchy(const Stiffness                                  &stiffness,
                   unsigned int                                      dim,
                   std::function<std::shared_ptr<const Hierarchy>()> make = {});

    /// Of the stiffness as it is now, or was; null where the preconditioner needs none. Collective.
    std::shared_ptr<const Hierarchy>
    get();

    /// What an iterative solution with it took, to be compared with what that was at first.
    void
    record_iterations(double iterations_per_digit);

    /// It is not of the stiffness as it is now. If so, it will be, when it is asked for again.
    bool
    request_rebuild();

    unsigned int
    dim() const
    {
      return my_dim;
    }

    /// Do zones of contact know of forces that turn (see InterfaceSolver)? Only where that saves
    /// more iterations than it costs.
    bool
    interface_includes_geometric_stiffness() const
    {
      return my_interface_includes_geometric;
    }

    void
    include_geometric_in_interface(const bool wanted)
    {
      my_interface_includes_geometric = wanted;
    }

  private:
    const Stiffness                                  &stiffness;
    const unsigned int                                my_dim;
    std::function<std::shared_ptr<const Hierarchy>()> make;
    std::shared_ptr<const Hierarchy>                  hierarchy;
    unsigned int version       = 0;     ///< of the stiffness that it is of
    bool         needs_rebuild = false; ///< to be made anew once the stiffness has changed
    double       first_iterations_per_digit      = 0; ///< iterations per digit; 0: not known yet
    bool         my_interface_includes_geometric = false;
  };
} // namespace Signorini
