#pragma once

#include <signorini/linear_algebra/types.h>

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

namespace Signorini
{
  /// Between vectors of all degrees of freedom and what a rank needs of them for the cells that it
  /// owns: an array with its own degrees of freedom first, and then copies of those of others that
  /// these cells touch, or that what they touch hangs on. Homogeneous constraints, u = C u_free,
  /// are dealt with here, so that loops over cells know nothing of them.
  template <typename Number>
  class LocalVectors
  {
  public:
    /// Collective.
    /// @param nodes by their first degrees of freedom of three, those that this rank needs; lists
    /// may name one more than once
    LocalVectors(const dealii::IndexSet                                &owned,
                 const std::vector<const std::vector<std::uint32_t> *> &nodes,
                 const dealii::AffineConstraints<double>               &constraints,
                 MPI_Comm                                               comm);

    /// Where a degree of freedom is in the arrays.
    std::uint32_t
    place(const dealii::types::global_dof_index dof) const
    {
      return partition->global_to_local(dof);
    }

    /// The inverse of place().
    dealii::types::global_dof_index
    dof(const std::uint32_t place) const
    {
      return partition->local_to_global(place);
    }

    /// Calls act(degree of freedom, weight) for what the element of C u at a place is the sum of.
    template <typename Action>
    void
    for_each_element(std::uint32_t place, const Action &act) const;

    /// The array of C u; constrained elements of u do not count. Collective. Valid, as the other
    /// one, until the next call.
    const Number *
    resolve(const LA::Vector &u) const;

    /// An array of zeros for the result.
    Number *
    zero() const;

    /// v = C^T f with the array f that zero() returned, zero at constrained elements. Collective.
    void
    condense(LA::Vector &v) const;

    /// v = f without regard to constraints. Collective.
    void
    sum(LA::Vector &v) const;

    /// The same with the largest instead of the sum.
    void
    largest(LA::Vector &v) const;

    /// Places of constrained elements of this rank.
    const std::vector<std::uint32_t> &
    owned_constrained() const
    {
      return my_owned_constrained;
    }

    std::size_t
    memory() const;

  private:
    using Vector = dealii::LinearAlgebra::distributed::Vector<Number>;

    void
    copy_owned(LA::Vector &v) const;

    std::shared_ptr<const dealii::Utilities::MPI::Partitioner> partition;

    // Constrained element k of the arrays is the sum of weights times elements from first[k] on.
    // They are sorted.
    std::vector<std::uint32_t> constrained, first, elements, my_owned_constrained;
    std::vector<Number>        weights;
    mutable Vector             of_u, of_f;
  };



  template <typename Number>
  template <typename Action>
  void
  LocalVectors<Number>::for_each_element(const std::uint32_t place, const Action &act) const
  {
    const auto line = std::lower_bound(constrained.begin(), constrained.end(), place);
    if (line == constrained.end() || *line != place)
      return act(dof(place), 1.);
    const std::size_t k = line - constrained.begin();
    for (std::uint32_t e = first[k]; e < first[k + 1]; ++e)
      act(dof(elements[e]), weights[e]);
  }
} // namespace Signorini
