// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh/mesh.h"
#include <signorini/solid/boundary_conditions.h>

#include <map>
#include <vector>

namespace Signorini
{
  /// Forces at nodes and points. Each acts on one of the cells that have the point: its shape
  /// functions, of any degree, distribute the force, f_i = N_i(x) F, with the same resultant and
  /// moment.
  template <int dim>
  class NodalForces
  {
  public:
    /// A force at a point of a cell.
    struct Force
    {
      const Load<dim> *load;
      /// The point in reference coordinates of the cell.
      dealii::Point<dim> unit;
      dealii::Point<dim> position;
      /// Number of nodes that share a total force.
      unsigned int n_shares;

      /// The force at time t [force].
      dealii::Tensor<1, dim>
      value(double t) const;
    };

    /// Find the cells of the loaded nodes and points. Collective.
    NodalForces(const Mesh<dim> &mesh, const std::vector<Load<dim>> &loads);

    /// The forces on an active cell of this rank; null if there are none.
    const std::vector<Force> *
    on(unsigned int active_cell) const;

  private:
    /// Add the forces at the nodes of sets.
    void
    add_set(const Mesh<dim> &mesh, const Load<dim> &load, const std::vector<std::string> &sets);
    /// Add the force at a point.
    void
    add_point(const Mesh<dim> &mesh, const Load<dim> &load);

    std::map<unsigned int, std::vector<Force>> by_cell;
  };
} // namespace Signorini
