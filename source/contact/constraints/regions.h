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
  /// The connectivity of contact points. Two points are connected if they lie on the same slave
  /// face; integration points also if their faces share a node. Stores numbers of surface nodes
  /// only.
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

    /// True if there are no contact points on any rank.
    bool
    empty() const
    {
      return !layout;
    }

    /// At each point with in > 0, the sum of `values` over the connected region of such points that
    /// contains it; elsewhere 0. Collective.
    LA::Vector
    sums(const LA::Vector &in, const LA::Vector &values) const;

    /// 1 at the points with in > 0 and at those next to them, which share a slave face or, at
    /// integration points, a node of their faces; elsewhere 0. Collective.
    LA::Vector
    with_neighbours(const LA::Vector &in) const;

    /// For nodal contact points with in > 0: the mean of `values` at the neighbours, the other
    /// nodes of the faces around, each as often as they share a face. Collective.
    /// @param complete set to 1 where all neighbours have in > 0, else to 0
    LA::Vector
    means_of_neighbours(const LA::Vector &in, const LA::Vector &values, LA::Vector &complete) const;

    /// True if the contact points are slave nodes, false if they are integration points.
    bool
    has_nodes() const
    {
      return at_nodes;
    }

  private:
    using Index   = dealii::types::global_dof_index;
    using Numbers = std::vector<unsigned int>; ///< of nodes on this rank, ghosts last

    /// The number of the region of each node on this rank; 0 outside. Collective.
    std::vector<Index>
    regions(const LA::Vector &in) const;

    /// Replace each number by the largest one that any rank has for the node. Collective.
    void
    maximise_over_ranks(std::vector<Index> &number) const;

    /// Sum over ranks. @param sum_of in: sums of this rank's points, by region number; out: those
    /// of all ranks
    void
    add_other_ranks(std::map<Index, double> &sum_of) const;

    bool                                                       at_nodes = false;
    std::vector<Numbers>                                       faces;  ///< nodes of slave faces
    std::vector<Numbers>                                       points; ///< of locally owned points
    std::shared_ptr<const dealii::Utilities::MPI::Partitioner> layout; ///< of the nodes
  };
} // namespace Signorini
