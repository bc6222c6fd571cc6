// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "linear_algebra/ghost_exchange.h"

#include <deal.II/lac/affine_constraints.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

namespace Signorini
{
  /// Conversion between distributed vectors of degrees of freedom and the arrays of a rank that
  /// loops over cells read and write: the owned degrees of freedom first, followed by copies of
  /// those of other ranks that the cells of this rank, or constraints of their degrees of freedom,
  /// refer to. Homogeneous constraints u = C u_free are applied here, outside of the loops over
  /// cells.
  template <typename Number>
  class LocalVectors
  {
  public:
    /// Collective.
    /// @param nodes lists of nodes that this rank needs, by their first degrees of freedom of
    /// three; a node may occur repeatedly
    LocalVectors(const dealii::IndexSet                                &owned,
                 const std::vector<const std::vector<std::uint32_t> *> &nodes,
                 const dealii::AffineConstraints<double>               &constraints,
                 MPI_Comm                                               comm);

    /// The position of a degree of freedom in the arrays.
    std::uint32_t
    local_index(const dealii::types::global_dof_index dof) const
    {
      return exchange->local_index(dof);
    }

    /// The inverse of local_index().
    dealii::types::global_dof_index
    dof(const std::uint32_t local_index) const
    {
      return exchange->dof(local_index);
    }

    /// Calls act(degree of freedom, weight) for what the element of C u at a place is the sum of.
    template <typename Action>
    void
    for_each_element(std::uint32_t local_index, const Action &act) const;

    /// The array of C u with the elements of u that this rank owns; constrained ones do not count.
    /// Collective. Valid, as the other one, until the next call. One more element may be read.
    const Number *
    resolve(const Number *u) const;

    /// An array of zeros for the result.
    Number *
    zero() const;

    /// C^T f of the degrees of freedom of this rank, with the array f that zero() returned, in its
    /// place; zero at constrained elements. Collective.
    Number *
    condense() const;

    /// The same for the diagonal f of a matrix, without the products of different elements, and
    /// with constrained elements left as they are.
    Number *
    condense_diagonal() const;

    /// The largest of f on all ranks, without regard to constraints.
    Number *
    largest() const;

    /// Places of constrained elements of this rank.
    const std::vector<std::uint32_t> &
    owned_constrained() const
    {
      return my_owned_constrained;
    }

  private:
    Number *
    sum() const;

    std::unique_ptr<const LA::GhostExchange<Number>> exchange;

    // Constrained element k of the arrays is the sum of weights times elements from first[k] on.
    // They are sorted.
    std::vector<std::uint32_t>  constrained, first, elements, my_owned_constrained;
    std::vector<Number>         weights;
    mutable std::vector<Number> of_u, of_f;
  };



  template <typename Number>
  template <typename Action>
  void
  LocalVectors<Number>::for_each_element(const std::uint32_t local_index, const Action &act) const
  {
    const auto line = std::lower_bound(constrained.begin(), constrained.end(), local_index);
    if (line == constrained.end() || *line != local_index)
      return act(dof(local_index), 1.);
    const std::size_t k = line - constrained.begin();
    for (std::uint32_t e = first[k]; e < first[k + 1]; ++e)
      act(dof(elements[e]), weights[e]);
  }
} // namespace Signorini
