// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/constraints/contact_rows.h"
#include "linear_algebra/types.h"

#include <deal.II/base/partitioner.h>

#include <map>
#include <memory>
#include <vector>

namespace Signorini
{
  /// Which contact points hang together: two do if they lie on the same slave face, of points of
  /// integration also on faces that share a node. Nothing is stored but numbers of surface nodes.
  class ContactRegions
  {
  public:
    ContactRegions() = default;

    /// @param rows those of the gap operator
    template <int dim>
    ContactRegions(const Elasticity<dim>                  &elasticity,
                   const std::vector<ContactSurface<dim>> &surfaces,
                   const ContactRows                      &rows,
                   Sampling                                sampling);

    bool
    empty() const
    {
      return !layout;
    }

    /// At each point with in > 0 the sum of `values` over all points with in > 0 that are connected
    /// with it by such points; elsewhere 0. Collective.
    LA::Vector
    sums(const LA::Vector &in, const LA::Vector &values) const;

    /// Of points that are nodes, where in > 0: the mean of the values at the neighbours, the other
    /// nodes of the faces around, as often as they share a face. `complete` becomes 1 where all
    /// neighbours have in > 0, else 0. Collective.
    LA::Vector
    means_of_neighbours(const LA::Vector &in, const LA::Vector &values, LA::Vector &complete) const;

    /// Points are nodes.
    bool
    has_nodes() const
    {
      return at_nodes;
    }

  private:
    using Index   = dealii::types::global_dof_index;
    using Numbers = std::vector<unsigned int>; ///< of nodes on this rank, ghosts last

    /// Of each node on this rank the number of its region, 0 outside.
    std::vector<Index>
    regions(const LA::Vector &in) const;

    /// The largest of the numbers that ranks have of a node. Collective.
    void
    maximise_over_ranks(std::vector<Index> &number) const;

    /// @param sum_of points of this rank, by numbers of regions; out: of all ranks
    void
    add_other_ranks(std::map<Index, double> &sum_of) const;

    bool                                                       at_nodes = false;
    std::vector<Numbers>                                       faces;  ///< nodes of slave faces
    std::vector<Numbers>                                       points; ///< of locally owned points
    std::shared_ptr<const dealii::Utilities::MPI::Partitioner> layout; ///< of the nodes
  };
} // namespace Signorini
