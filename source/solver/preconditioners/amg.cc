// SPDX-License-Identifier: Apache-2.0
#include "solver/preconditioners/amg.h"

#include "linear_algebra/values.h"
#include "solver/preconditioners/largest_eigenvalue.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// A start vector for the estimate of the largest eigenvalue of D^-1 K: an oscillation times a
    /// function that is largest where the row sums are large beside the diagonal. The eigenvector
    /// is localised at the few badly shaped cells there; from a start that is equally large
    /// everywhere, one cell among millions would not be found in a few steps. Collective.
    /// @param row_l1_norms l1 norms of the rows of K; @param inverse_diagonal 1/D, zero for empty
    /// rows
    std::vector<float>
    stiff_oscillation(std::vector<float>        row_l1_norms,
                      const std::vector<float> &inverse_diagonal,
                      const MPI_Comm            comm)
    {
      constexpr double    power = 16, everywhere = 0.01;
      std::vector<float> &r       = row_l1_norms;
      double              largest = 0;
      for (std::size_t i = 0; i < r.size(); ++i)
        {
          r[i] *= inverse_diagonal[i];
          largest = std::max(largest, double(r[i]));
        }
      largest = Utilities::MPI::max(largest, comm);
      for (std::size_t i = 0; i < r.size(); ++i)
        r[i] = inverse_diagonal[i] == 0 ?
                 0 :
                 std::sin(1. + 1.7 * i * i) * (everywhere + std::pow(r[i] / largest, power)) /
                   std::sqrt(inverse_diagonal[i]);
      return row_l1_norms;
    }
  } // namespace



  // Set up the levels of the hierarchy. Eigenvalues are estimated once, with the largest contact
  // stiffness everywhere, so that the smoother is stable for any active set. Collective.
  AMG::AMG(const Hierarchy &hierarchy, const GapOperator *contact)
    : coarsest_K(hierarchy.coarsest_matrix())
    , direct(LA::DirectLibrary::KLU)
    , coarsest_x(coarsest_K.locally_owned_range_indices(), coarsest_K.get_mpi_communicator())
    , coarsest_right(coarsest_x)
  {
    if (contact && !contact->empty())
      contact_stiffness.emplace(hierarchy, *contact);
    for (unsigned int l = 0; l < hierarchy.n_levels(); ++l)
      {
        levels.push_back(std::make_unique<Level>());
        Level &level           = *levels.back();
        level.number           = l;
        level.K                = &hierarchy.stiffness(l);
        level.diagonal_K       = level.K->diagonal();
        level.smoothing_degree = hierarchy.smoothing_degree(l);
        level.n_visits         = hierarchy.n_visits(l);
        if (l + 1 < hierarchy.n_levels())
          level.P = &hierarchy.prolongation(l);
        for (std::vector<float> *v : {&level.x, &level.right, &level.step})
          v->resize(level.diagonal_K.size());
        if (level.n_visits == 2)
          level.first.resize(level.diagonal_K.size());
      }
    // With contact stiffness at all points eigenvalues are largest: the bounds hold for any active
    // set.
    if (contact_stiffness)
      contact_stiffness->stiffen();
    for (auto &level : levels)
      {
        update_diagonal(*level);
        if (level->P)
          estimate_eigenvalue(*level);
      }
    if (contact_stiffness)
      contact_stiffness->remove();
    else
      update();
  }



  void
  AMG::set_contact_stiffness(const PointVectors &values)
  {
    if (!contact_stiffness)
      return;
    contact_stiffness->set(values);
    update();
  }



  // After a change of the contact stiffness only diagonals and the factorisation of the coarsest
  // level change.
  void
  AMG::update()
  {
    for (auto &level : levels)
      update_diagonal(*level);
    factorise();
  }



  void
  AMG::update_diagonal(Level &level)
  {
    level.inverse_diagonal = level.diagonal_K;
    if (contact_stiffness)
      contact_stiffness->add_diagonal(level.number, level.inverse_diagonal.data());
    for (float &d : level.inverse_diagonal)
      d = d == 0 ? 0 : 1 / d; // aggregates may leave empty rows
  }



  void
  AMG::estimate_eigenvalue(Level &level)
  {
    std::vector<float> row_l1_norms = level.K->row_l1_norms();
    if (contact_stiffness)
      contact_stiffness->add_row_sums(level.number, row_l1_norms.data());
    const MPI_Comm comm = level.K->communicator();
    level.largest_eigenvalue =
      largest_eigenvalue([&](const float *x) { return multiply(level, x); },
                         level.inverse_diagonal,
                         stiff_oscillation(row_l1_norms, level.inverse_diagonal, comm),
                         comm);
  }



  void
  AMG::factorise()
  {
    const Level &last = *levels.back();
    direct.clear();
    coarsest.reset();
    if (contact_stiffness && contact_stiffness->any())
      coarsest = std::make_unique<LA::SparseMatrix>(
        contact_stiffness->sum_with_contact_stiffness(coarsest_K, last.number));
    const int error = direct.factorise(coarsest ? *coarsest : coarsest_K);
    AssertThrow(error == 0, ExcTrilinosError(error));
  }



  float *
  AMG::multiply(const Level &level, const float *x) const
  {
    float *const product = level.K->product(x);
    if (contact_stiffness)
      contact_stiffness->add_product(level.number, product, x);
    return product;
  }



  /// The residual right - K x; the array is valid until the next product.
  float *
  AMG::residual(const Level &level) const
  {
    float *const       rest  = multiply(level, level.x.data());
    const float *const right = level.right.data();
    for (std::size_t i = 0; i < level.right.size(); ++i)
      rest[i] = right[i] - rest[i];
    return rest;
  }



  // Chebyshev smoother x <- x + p(D^-1 A) D^-1 r with the recurrence (7.2) and the bounds (7.3).
  void
  AMG::smooth(const Level &level, const bool from_zero) const
  {
    // Chebyshev polynomial on the upper part of the spectrum, from Lambda/20 to Lambda = 1.1 times
    // the estimate (Saad, Iterative Methods for Sparse Linear Systems, algorithm 12.1).
    const double largest = 1.1 * level.largest_eigenvalue, smallest = largest / 20;
    const double theta = (largest + smallest) / 2, delta = (largest - smallest) / 2;
    const double sigma = theta / delta;
    double       rho   = 1 / sigma;

    const auto advance = [&](const float of_step, const float of_rest, const float *rest) {
      float *const x = level.x.data(), *const step = level.step.data();
      const float *const inverse = level.inverse_diagonal.data();
      for (std::size_t i = 0; i < level.x.size(); ++i)
        {
          step[i] = of_step * step[i] + of_rest * inverse[i] * rest[i];
          x[i] += step[i];
        }
    };
    if (from_zero)
      std::fill(level.x.begin(), level.x.end(), 0.f);
    advance(0, 1 / theta, from_zero ? level.right.data() : residual(level));
    for (unsigned int k = 1; k < level.smoothing_degree; ++k)
      {
        const double next = 1 / (2 * sigma - rho);
        advance(next * rho, 2 * next / delta, residual(level));
        rho = next;
      }
  }



  void
  AMG::solve_coarsest(const Level &level) const
  {
    std::copy(level.right.begin(), level.right.end(), LA::values_of(coarsest_right));
    direct.solve(coarsest_x, coarsest_right);
    std::copy_n(LA::values_of(coarsest_x), level.x.size(), level.x.begin());
  }



  // One cycle on level l: smooth, restrict the residual, solve on the next level (once, or twice
  // for a W-cycle), prolongate, smooth. The same number of smoothing steps before and after makes
  // the cycle symmetric. Recursion ends at the coarsest level.
  void
  AMG::cycle(const unsigned int l) const
  {
    const Level &level = *levels[l];
    if (!level.P)
      {
        solve_coarsest(level);
        return;
      }
    smooth(level, true);
    const Level &next = *levels[l + 1];
    level.P->Tvmult(next.right.data(), residual(level));
    cycle(l + 1);
    // W-cycle: solve once more for the residual.
    if (next.P && next.n_visits == 2)
      {
        next.first              = next.x;
        const float *const rest = residual(next);
        std::copy_n(rest, next.right.size(), next.right.begin());
        cycle(l + 1);
        for (std::size_t i = 0; i < next.x.size(); ++i)
          next.x[i] += next.first[i];
      }
    level.P->vmult_add(level.x.data(), next.x.data());
    smooth(level, false);
  }



  void
  AMG::vmult(LA::Vector &dst, const LA::Vector &src) const
  {
    ++n_cycles;
    if (levels.size() == 1)
      {
        // A single level is factorised, so that the cycle is exact.
        direct.solve(dst, src);
        return;
      }
    // Vectors are scaled to size one, for the range of single precision with any units.
    const double size = src.linfty_norm();
    if (size == 0)
      {
        dst = 0;
        return;
      }
    const Level        &finest = *levels.front();
    const double *const from   = LA::values_of(src);
    for (std::size_t i = 0; i < finest.right.size(); ++i)
      finest.right[i] = from[i] / size;
    cycle(0);
    double *const to = LA::values_of(dst);
    for (std::size_t i = 0; i < finest.x.size(); ++i)
      to[i] = finest.x[i] * size;
  }
} // namespace Signorini
