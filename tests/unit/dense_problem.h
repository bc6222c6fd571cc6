// SPDX-License-Identifier: Apache-2.0
// Contact problems of a few unknowns, given as matrices.
#pragma once

#include "contact/constraints/gap_operator.h"
#include "solver/solid_residual.h"

#include <deal.II/base/conditional_ostream.h>
#include <deal.II/base/timer.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <sstream>

#include <Eigen/Core>

namespace TestScene
{
  using namespace Signorini;
  using namespace dealii;

  /// Output that is kept instead of printed, and a timer that prints nothing.
  struct Silence
  {
    std::ostringstream log;
    ConditionalOStream out{log, true};
    TimerOutput        timer{out, TimerOutput::never, TimerOutput::wall_times};
  };

  /// K u = f + B^T p with gaps g = B u + g_0 and areas of one; all on the first rank. With several
  /// components a point, the rows of B that follow each other are those of a point.
  struct DenseProblem
  {
    DenseProblem(const Eigen::MatrixXd &K,
                 const Eigen::VectorXd &f,
                 const Eigen::MatrixXd &B,
                 const Eigen::VectorXd &g_0,
                 const double           epsilon,
                 const unsigned int     n_components = 1)
      : owned(LA::contiguous_partition(
          Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0 ? K.rows() : 0, MPI_COMM_WORLD))
      , load(owned, MPI_COMM_WORLD)
      , stiffness(matrix(owned, [&](const auto i, const auto j) { return K(i, j); }))
    {
      constraints.close();
      const IndexSet points =
        LA::contiguous_partition(owned.n_elements() / n_components, MPI_COMM_WORLD);
      const auto rows = [&](const unsigned int a) {
        return matrix(points,
                      [&, a](const auto i, const auto j) { return B(n_components * i + a, j); });
      };
      const auto gaps = [&](const unsigned int a) {
        LA::Vector result(points, MPI_COMM_WORLD);
        for (const auto i : points)
          result(i) = g_0[n_components * i + a];
        result.compress(VectorOperation::insert);
        return result;
      };
      contact.dofs = owned;
      contact.origin.pair.assign(points.n_elements(), 0);
      contact.B.copy_from(rows(0));
      contact.B_free.copy_from(contact.B);
      contact.reference_gap = contact.initial_gap = gaps(0);
      for (unsigned int a = 1; a < n_components; ++a)
        {
          contact.tangential.B.push_back(rows(a));
          contact.tangential.B_free.push_back(rows(a));
          contact.tangential.offset.push_back(gaps(a));
        }
      for (LA::Vector *v : {&contact.weight,
                            &contact.coefficients.stiffness,
                            &contact.coefficients.epsilon,
                            &contact.coefficients.friction,
                            &contact.coefficients.least_status})
        v->reinit(points, MPI_COMM_WORLD);
      contact.weight                 = 1.;
      contact.coefficients.stiffness = 1.;
      contact.coefficients.epsilon   = epsilon;
      for (const auto i : owned)
        load(i) = f[i];
      load.compress(VectorOperation::insert);
    }

    /// @param entry of row and column, for rows of this rank
    template <typename Entry>
    LA::SparseMatrix
    matrix(const IndexSet &rows, const Entry &entry) const
    {
      DynamicSparsityPattern full(rows.size(), owned.size());
      for (unsigned int i = 0; i < rows.size(); ++i)
        for (unsigned int j = 0; j < owned.size(); ++j)
          full.add(i, j);
      LA::SparseMatrix result;
      result.reinit(rows, owned, full, MPI_COMM_WORLD);
      for (const auto i : rows)
        for (unsigned int j = 0; j < owned.size(); ++j)
          result.set(i, j, entry(i, j));
      result.compress(VectorOperation::insert);
      return result;
    }

    LinearElasticSolid
    bodies() const
    {
      LinearElasticSolid result(std::make_unique<AssembledStiffness>(stiffness),
                                {},
                                constraints,
                                std::vector<unsigned int>(owned.n_elements(), 0));
      result.set_load(load);
      return result;
    }

    IndexSet                  owned;
    LA::Vector                load;
    LA::SparseMatrix          stiffness;
    AffineConstraints<double> constraints;
    GapOperator               contact;
  };
} // namespace TestScene
