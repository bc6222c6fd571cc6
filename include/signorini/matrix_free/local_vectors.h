#pragma once

#include <signorini/linear_algebra/types.h>

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <cstdint>
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
    /// Collective. @param touched by the cells of this rank; may have duplicates
    LocalVectors(const dealii::IndexSet                             &owned,
                 const std::vector<dealii::types::global_dof_index> &touched,
                 const dealii::AffineConstraints<double>            &constraints,
                 MPI_Comm                                            comm);

    /// Where a degree of freedom is in the arrays.
    std::uint32_t
    place(const dealii::types::global_dof_index dof) const
    {
      return partition->global_to_local(dof);
    }

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
    std::vector<std::uint32_t> constrained, first, elements, my_owned_constrained;
    std::vector<Number>        weights;
    mutable Vector             of_u, of_f;
  };
} // namespace Signorini
