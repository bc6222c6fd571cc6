// SPDX-License-Identifier: Apache-2.0
// The contact stiffness of all points of a rank as one sparse matrix over the degrees of freedom of
// its surfaces, for systems without multipliers.
#include "linear_algebra/row_view.h"
#include "linear_algebra/values.h"
#include "solver/contact_system.h"

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <algorithm>

#include <Eigen/Core>

namespace Signorini
{
  using namespace dealii;

  // Sparsity pattern of the surface stiffness over the local columns of B_free: the columns of each
  // row are coupled. Consecutive rows between the same two faces have the same columns and are
  // added once.
  void
  ContactSystem::make_surface_pattern()
  {
    columns.emplace(contact.B_free);
    DynamicSparsityPattern entries(columns->size(), columns->size());
    const int              n_rows = contact.weight.locally_owned_size();
    for (int row = 0; row < n_rows; ++row)
      {
        const LA::RowView view(contact.B_free, row);
        if (row > 0 && view.has_columns_of(LA::RowView(contact.B_free, row - 1)))
          continue;
        std::vector<unsigned int> sorted(view.columns, view.columns + view.size);
        std::sort(sorted.begin(), sorted.end());
        for (const unsigned int column : sorted)
          entries.add_entries(column, sorted.begin(), sorted.end(), true);
      }
    pattern.copy_from(entries);
    surface.reinit(pattern);
    displacement.reinit(columns->size());
    force.reinit(columns->size());
  }



  namespace
  {
    /// The differences of the blocks to those of `before`, point by point; `before` is set to the
    /// present ones.
    std::vector<std::vector<double>>
    changes(const ContactSystem::Blocks &now, std::vector<std::vector<double>> &before)
    {
      std::vector<std::vector<double>> result;
      before.resize(now.size() * now.size());
      for (const PointVectors &row : now)
        for (const LA::Vector &block : row)
          {
            std::vector<double> &last   = before[result.size()];
            const double *const  values = LA::values_of(block);
            const unsigned int   n      = block.locally_owned_size();
            last.resize(n, 0.);
            result.emplace_back(n);
            for (unsigned int i = 0; i < n; ++i)
              {
                result.back()[i] = values[i] - last[i];
                last[i]          = values[i];
              }
          }
      return result;
    }

    using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

    /// The contact stiffness of points with the same columns as L^T R, where each summand of (4.4)
    /// in doc/theory is a row of both.
    struct Product
    {
      std::vector<double> L, R; ///< row by row

      void
      add_row(const double *left, const Eigen::RowVectorXd &right)
      {
        L.insert(L.end(), left, left + right.size());
        R.insert(R.end(), right.data(), right.data() + right.size());
      }

      Matrix
      value(const int n_columns) const
      {
        const int n_rows = L.size() / n_columns;
        return Eigen::Map<const Matrix>(L.data(), n_rows, n_columns).transpose() *
               Eigen::Map<const Matrix>(R.data(), n_rows, n_columns);
      }
    };
  } // namespace



  // Sum up the contact stiffness of all points of this rank in the matrix `surface`: one product
  // with it replaces those with B, D and B^T in each iteration. Cost: points times squares of their
  // columns, once for each linearisation.
  void
  ContactSystem::sum_up_surface_stiffness()
  {
    if (surface.empty())
      return; // no points on this rank
    // With stresses open points contribute too, and most points are unchanged between two
    // active sets: only differences are added. Without them the matrix is summed up anew, since the
    // differences of stiff penalties would leave rounding errors.
    if (!contact.has_stress())
      {
        surface = 0;
        sums    = Sums();
      }
    const Sums                           change{changes(D, sums.D),
                      changes(X, sums.X),
                      changes(Y, sums.Y),
                      changes(Z, sums.Z)};
    const int                            n_points = contact.weight.locally_owned_size();
    const unsigned int                   n        = law.n_components();
    std::vector<types::global_dof_index> indices;
    for (int first = 0, last = 0; first < n_points; first = last)
      {
        const LA::RowView columns(contact.B_free, first);
        Product           product;
        for (; last < n_points && LA::RowView(contact.B_free, last).has_columns_of(columns); ++last)
          for (unsigned int a = 0; a < n; ++a)
            for (unsigned int b = 0; b < n; ++b)
              {
                const unsigned int ab = a * n + b;
                const double       d = change.D[ab][last], x = change.X[ab][last],
                             y = contact.theta * change.Y[ab][last],
                             z = contact.theta * change.Z[ab][last];
                const auto row = [&](const LA::SparseMatrix &matrix) {
                  return Eigen::Map<const Eigen::RowVectorXd>(LA::RowView(matrix, last).values,
                                                              columns.size);
                };
                // B_a^T (d B_b - x S_b) - S_a^T (z B_b + y S_b)
                const auto B_b = row(contact.free_rows(b));
                if (contact.has_stress() && x != 0)
                  product.add_row(row(contact.free_rows(a)).data(),
                                  d * B_b - x * row(contact.S_free[b]));
                else if (d != 0)
                  product.add_row(row(contact.free_rows(a)).data(), d * B_b);
                if (contact.has_stress() && (y != 0 || z != 0))
                  product.add_row(row(contact.S_free[a]).data(),
                                  -z * B_b - y * row(contact.S_free[b]));
              }
        if (product.L.empty())
          continue;
        const Matrix block = product.value(columns.size);
        indices.assign(columns.columns, columns.columns + columns.size);
        // Sorted columns are added several times as fast.
        const bool is_sorted = std::is_sorted(indices.begin(), indices.end());
        for (int k = 0; k < columns.size; ++k)
          surface.add(
            indices[k], columns.size, indices.data(), block.row(k).data(), false, is_sorted);
      }
  }
} // namespace Signorini
