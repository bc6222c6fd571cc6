// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/elasticity.h"
#include "solver/preconditioners/hierarchy.h"
#include <signorini/solver/linear_solver_settings.h>

#include <functional>
#include <memory>

namespace Signorini
{
  /// The multigrid hierarchy of the solids' stiffness, made on demand and kept when contact is
  /// searched for again. When the stiffness changes, its finest level follows at once; the coarser
  /// levels are rebuilt when the iterations per digit show that they no longer fit.
  class SolidHierarchy
  {
  public:
    /// Keeps references to stiffness and elasticity.
    template <int d>
    SolidHierarchy(const LinearSolverSettings &settings,
                   const Stiffness            &stiffness,
                   const Elasticity<d>        &elasticity);

    /// @param dim components of a node
    /// @param make empty: there is none
    SolidHierarchy(const Stiffness                                  &stiffness,
                   unsigned int                                      dim,
                   std::function<std::shared_ptr<const Hierarchy>()> make = {});

    /// The hierarchy of the present stiffness or of a former one; null if the preconditioner needs
    /// none. Collective.
    std::shared_ptr<const Hierarchy>
    get();

    /// Record the iterations per digit of a solution, to be compared with those of the first one.
    void
    record_iterations(double iterations_per_digit);

    /// If the hierarchy is not that of the present stiffness, have get() rebuild it, and return
    /// true.
    bool
    request_rebuild();

    /// The dimension of space, which is the number of unknowns of a node.
    unsigned int
    dim() const
    {
      return my_dim;
    }

    /// True if interface solves include the contact geometric stiffness (see InterfaceSolver),
    /// which pays only if it saves more iterations than it costs.
    bool
    interface_includes_geometric_stiffness() const
    {
      return my_interface_includes_geometric;
    }

    /// Choose whether interface solves include the contact geometric stiffness.
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
