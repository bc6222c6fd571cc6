// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh/mesh.h"
#include <signorini/solid/boundary_conditions.h>

#include <map>
#include <vector>

namespace Signorini
{
  /// Forces at nodes and points, each on one of the cells that have it: whatever the degree of the
  /// displacement there, its functions take shares of the force that add up to it, with the same
  /// moment, f_i = N_i(x) F.
  template <int dim>
  class NodalForces
  {
  public:
    struct Force
    {
      const Load<dim>   *load;
      dealii::Point<dim> unit; ///< in the cell
      dealii::Point<dim> position;
      unsigned int       n_shares; ///< of a total force

      dealii::Tensor<1, dim>
      value(double t) const;
    };

    /// Find the cells of the loaded nodes and points. Collective.
    NodalForces(const Mesh<dim> &mesh, const std::vector<Load<dim>> &loads);

    /// The forces on an active cell of this rank; null if there are none.
    const std::vector<Force> *
    on(unsigned int active_cell) const;

  private:
    void
    add_set(const Mesh<dim> &mesh, const Load<dim> &load, const std::vector<std::string> &sets);
    void
    add_point(const Mesh<dim> &mesh, const Load<dim> &load);

    std::map<unsigned int, std::vector<Force>> by_cell;
  };
} // namespace Signorini
