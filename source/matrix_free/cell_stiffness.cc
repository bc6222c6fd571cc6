// SPDX-License-Identifier: Apache-2.0
#include "matrix_free/cell_stiffness.h"

#include "linear_algebra/diagonal.h"
#include "linear_algebra/values.h"
#include "solid/cell_nodes.h"

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  // The product is in an array of the operator that is valid until its next product; it is copied.
  void
  CellStiffness::vmult(LA::Vector &dst, const LA::Vector &src) const
  {
    std::copy_n(in_double_precision->product(LA::values_of(src)),
                dst.locally_owned_size(),
                LA::values_of(dst));
  }



  // The product is added where it is, without a vector for it.
  void
  CellStiffness::vmult_add(LA::Vector &dst, const LA::Vector &src) const
  {
    const double *const product = in_double_precision->product(LA::values_of(src));
    double *const       sum     = LA::values_of(dst);
    for (unsigned int i = 0; i < dst.locally_owned_size(); ++i)
      sum[i] += product[i];
  }



  LA::Vector
  CellStiffness::diagonal() const
  {
    LA::Vector                result(owned(), communicator());
    const std::vector<double> values = in_double_precision->diagonal();
    std::copy(values.begin(), values.end(), LA::values_of(result));
    return result;
  }



  namespace
  {
    /// True on all ranks if any degree of freedom is marked that was not marked before. Collective.
    bool
    has_more(const LA::Vector &marker, const LA::Vector &before)
    {
      const double *const now = LA::values_of(marker);
      const double *const old = before.size() > 0 ? LA::values_of(before) : nullptr;
      // The old marks are empty before the first call: then any mark is new.
      bool any = false;
      for (unsigned int i = 0; i < marker.locally_owned_size() && !any; ++i)
        any = now[i] != 0 && !(old && old[i] != 0);
      return Utilities::MPI::max(any ? 1 : 0, marker.get_mpi_communicator()) == 1;
    }

    /// Mark all components of each node of which one is marked: they belong to the same cells, and
    /// contact surfaces that move will need them next.
    void
    mark_nodes(const LA::Vector &marker, LA::Vector &marked)
    {
      const double *const now = LA::values_of(marker);
      double *const       all = LA::values_of(marked);
      const unsigned int  n   = marker.locally_owned_size();
      for (unsigned int i = 0; i < n; ++i)
        // The components of a node are three consecutive degrees of freedom of one rank, which
        // begin at multiples of three.
        if (now[i] != 0)
          std::fill(all + i - i % 3, all + std::min(n, i - i % 3 + 3), 1.);
    }
  } // namespace



  // Rows of marked degrees of freedom, assembled from the cells around them. Marks accumulate, so
  // that the matrix is assembled again only when there are new ones; once the whole matrix exists,
  // it is returned. Collective.
  const LA::SparseMatrix &
  CellStiffness::rows(const LA::Vector &marker) const
  {
    if (whole)
      return *whole;
    const bool is_more = has_more(marker, marked);
    if (some_rows && !is_more)
      return *some_rows;
    if (marked.size() == 0)
      marked.reinit(marker);
    if (is_more)
      mark_nodes(marker, marked);

    // Marks of ghosts, so that cells of this rank next to marked degrees of freedom of others are
    // assembled too. A constrained degree of freedom belongs to the rows of those that it depends
    // on.
    LA::Vector seen(elasticity.owned(), elasticity.relevant(), communicator());
    seen                                             = marked;
    const AffineConstraints<double>     &constraints = elasticity.constraints();
    std::vector<types::global_dof_index> indices;
    const auto                           reaches = [&](const types::global_dof_index dof) {
      const auto *line = constraints.get_constraint_entries(dof);
      return seen(dof) != 0 ||
             (line && std::any_of(line->begin(), line->end(), [&](const auto &entry) {
                return seen(entry.first) != 0;
              }));
    };
    // Rows of marked degrees of freedom are complete, others contain a part of their cells only,
    // and must not be used.
    some_rows = std::make_unique<LA::SparseMatrix>();
    assemble(*some_rows, [&](const Cell &cell) {
      read_indices<3>(cell, indices);
      return std::any_of(indices.begin(), indices.end(), reaches);
    });
    LA::add_to_diagonal(*some_rows, elasticity.diagonal_terms());
    return *some_rows;
  }



  // The whole matrix replaces single rows, of which it is a superset.
  const LA::SparseMatrix &
  CellStiffness::matrix() const
  {
    if (!whole)
      {
        whole = std::make_unique<LA::SparseMatrix>();
        assemble(*whole, [](const Cell &) { return true; });
        LA::add_to_diagonal(*whole, elasticity.diagonal_terms());
        some_rows.reset();
      }
    return *whole;
  }



  // With a new version, preconditioners are rebuilt for the new K; matrices of the former K are
  // discarded.
  void
  CellStiffness::has_changed()
  {
    ++my_version;
    some_rows.reset();
    whole.reset();
  }



  // Linear bodies: the same cells in both precisions, in double precision for residuals and Krylov
  // vectors, in single precision for smoothers.
  MatrixFreeStiffness::MatrixFreeStiffness(const Elasticity<3> &elasticity)
    : CellStiffness(elasticity)
  {
    const CellSpace space = cell_space(elasticity);
    in_double_precision.emplace(space);
    in_single_precision.emplace(space);
  }



  void
  MatrixFreeStiffness::assemble(LA::SparseMatrix                        &K,
                                const std::function<bool(const Cell &)> &takes) const
  {
    elasticity.assembly().assemble(K, takes);
  }
} // namespace Signorini
