// SPDX-License-Identifier: Apache-2.0
// A stiffness without a matrix, or a level of multigrid, against what it stands for.
#pragma once

#include "linear_algebra/diagonal.h"
#include "linear_algebra/values.h"
#include "multigrid/level.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "small_scene.h"

namespace TestScene
{
  inline std::vector<float>
  single_precision(const LA::Vector &v)
  {
    return std::vector<float>(LA::values_of(v), LA::values_of(v) + v.locally_owned_size());
  }

  inline LA::Vector
  times(const StiffnessOperator<float> &K, const LA::Vector &u)
  {
    LA::Vector               result = u;
    const std::vector<float> x      = single_precision(u);
    std::copy_n(K.product(x.data()), x.size(), LA::values_of(result));
    return result;
  }

  inline LA::Vector
  times(const Prolongation &P, const LA::Vector &coarse, const dealii::IndexSet &fine)
  {
    LA::Vector               result(fine, MPI_COMM_WORLD);
    const std::vector<float> x = single_precision(coarse);
    std::vector<float>       y(result.locally_owned_size(), 0.f);
    P.vmult_add(y.data(), x.data());
    std::copy(y.begin(), y.end(), LA::values_of(result));
    return result;
  }

  inline LA::Vector
  transposed_times(const Prolongation &P, const LA::Vector &fine, const dealii::IndexSet &coarse)
  {
    LA::Vector               result(coarse, MPI_COMM_WORLD);
    const std::vector<float> x = single_precision(fine);
    std::vector<float>       y(result.locally_owned_size());
    P.Tvmult(y.data(), x.data());
    std::copy(y.begin(), y.end(), LA::values_of(result));
    return result;
  }

  inline double
  distance(const LA::Vector &a, const LA::Vector &b)
  {
    LA::Vector difference = a;
    difference -= b;
    return difference.linfty_norm() / b.linfty_norm();
  }

  /// Exact where nothing hangs on a degree of freedom, of the right size elsewhere.
  inline void
  check_diagonal(const Elasticity<3> &elasticity,
                 LA::Vector           diagonal,
                 const LA::Vector    &known,
                 const double         tolerance = 1e-12)
  {
    CHECK(diagonal.min() > 0);
    const auto &constraints = elasticity.constraints();
    LA::Vector  n_tied      = elasticity.zero_vector();
    for (const auto &line : constraints.get_lines())
      if (elasticity.owned().is_element(line.index))
        for (const auto &entry : line.entries)
          n_tied(entry.first) += 1;
    n_tied.compress(VectorOperation::add);
    double worst = 0, worst_tied = 1;
    for (const auto i : diagonal.locally_owned_elements())
      if (!constraints.is_constrained(i))
        {
          const double ratio = diagonal(i) / known(i);
          if (n_tied(i) == 0)
            worst = std::max(worst, std::abs(ratio - 1));
          else
            worst_tied = std::max({worst_tied, ratio, 1 / ratio});
        }
    CHECK(worst < tolerance);
    CHECK(worst_tied < 2);
  }

  inline void
  check_rows(const LA::SparseMatrix &K, const Stiffness &stiffness, const LA::Vector &marker)
  {
    const LA::SparseMatrix &rows  = stiffness.rows(marker);
    double                  worst = 0;
    for (unsigned int i = 0; i < marker.locally_owned_size(); ++i)
      if (LA::values_of(marker)[i] != 0)
        {
          const auto global = marker.locally_owned_elements().nth_index_in_set(i);
          for (auto entry = K.begin(global); entry != K.end(global); ++entry)
            worst = std::max(worst, std::abs(entry->value() - rows.el(global, entry->column())));
        }
    CHECK(Utilities::MPI::max(worst, MPI_COMM_WORLD) < 1e-12 * K.linfty_norm());
  }
  /// |P^T K P u - K_coarse u| / |K_coarse u| for a rough u on the coarse level.
  inline double
  galerkin_defect(const StiffnessOperator<float> &fine, const Level &coarse)
  {
    const Prolongation    &P     = *coarse.prolongation;
    const dealii::IndexSet below = coarse.stiffness->owned();
    // Constrained degrees of freedom stand for nothing: nothing is prolongated from there.
    LA::Vector ones(fine.owned(), MPI_COMM_WORLD);
    ones         = 1.;
    LA::Vector u = transposed_times(P, ones, below);
    for (const auto i : u.locally_owned_elements())
      u(i) = std::abs(u(i)) > 1e-6 ? std::sin(1 + 2. * i * i) : 0.;
    u.compress(VectorOperation::insert);
    const LA::Vector forces = times(fine, times(P, u, fine.owned()));
    return distance(times(*coarse.stiffness, u), transposed_times(P, forces, below));
  }
} // namespace TestScene
