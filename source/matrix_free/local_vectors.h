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

    /// Calls act(degree of freedom, weight) for each element of u in the sum that is the element of
    /// C u at the local index.
    template <typename Action>
    void
    for_each_element(std::uint32_t local_index, const Action &act) const;

    /// The array of C u, with its ghosts, from the elements of u that this rank owns; the values of
    /// constrained ones are ignored. Collective. Valid until the next call; one element beyond the
    /// end may be read.
    const Number *
    resolve(const Number *u) const;

    /// An array of zeros for the result.
    Number *
    zero() const;

    /// C^T f of the degrees of freedom that this rank owns, in the place of the array f that zero()
    /// returned; zero at constrained elements. Collective.
    Number *
    condense() const;

    /// condense() for the diagonal f of a matrix: with squared weights, and with constrained
    /// elements left as they are. Collective.
    Number *
    condense_diagonal() const;

    /// The largest value of f over all ranks, for degrees of freedom that this rank owns; without
    /// regard to constraints. Collective.
    Number *
    largest() const;

    /// Local indices of the constrained elements that this rank owns.
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
