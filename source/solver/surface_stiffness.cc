// SPDX-License-Identifier: Apache-2.0
// The contact stiffness of all points of a rank as one sparse matrix over the degrees of freedom of
// its surfaces, for systems without multipliers.
#include "linear_algebra/row_view.h"
#include "linear_algebra/values.h"
#include "solver/contact_system.h"

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>

#include <algorithm>

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

    /// The contact stiffness between the components a (left) and b (right) of a point, the 2 x 2
    /// matrix of doc/theory, (4.4).
    struct PointStiffness
    {
      double d, x, y, z; ///< see ContactSystem; y and z times theta

      bool
      is_zero() const
      {
        return d == 0 && x == 0 && y == 0 && z == 0;
      }

      /// Add B_a^T (d B_b - x S_b) - S_a^T (z B_b + y S_b) to a block over the columns of the
      /// point.
      /// @param S_a,S_b rows of the stress; null: the method does not use it
      void
      add_to(FullMatrix<double> &block,
             const double       *B_a,
             const double       *S_a,
             const double       *B_b,
             const double       *S_b) const
      {
        const unsigned int n = block.m();
        for (unsigned int k = 0; k < n; ++k)
          for (unsigned int l = 0; l < n; ++l)
            {
              double sum = B_a[k] * (S_b ? d * B_b[l] - x * S_b[l] : d * B_b[l]);
              if (S_a)
                sum -= S_a[k] * (S_b ? z * B_b[l] + y * S_b[l] : z * B_b[l]);
              block(k, l) += sum;
            }
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
    FullMatrix<double>                   block; // sum over points between the same two faces
    std::vector<types::global_dof_index> indices;
    for (int first = 0, last = 0; first < n_points; first = last)
      {
        const LA::RowView columns(contact.B_free, first);
        block.reinit(columns.size, columns.size);
        bool any = false;
        for (; last < n_points && LA::RowView(contact.B_free, last).has_columns_of(columns); ++last)
          any |= add_point(block, last, change);
        if (!any)
          continue;
        indices.assign(columns.columns, columns.columns + columns.size);
        surface.add(indices, block);
      }
  }



  // Add the contribution of one point, from the differences of its blocks; false if all of them are
  // zero.
  bool
  ContactSystem::add_point(FullMatrix<double> &block, const int point, const Sums &of) const
  {
    const unsigned int n        = law.n_components();
    const auto         row_of_S = [&](const unsigned int a) -> const double         *{
      return contact.has_stress() ? LA::RowView(contact.S_free[a], point).values : nullptr;
    };
    bool any = false;
    for (unsigned int a = 0; a < n; ++a)
      for (unsigned int b = 0; b < n; ++b)
        {
          const unsigned int   ab = a * n + b;
          const PointStiffness stiffness{of.D[ab][point],
                                         of.X[ab][point],
                                         contact.theta * of.Y[ab][point],
                                         contact.theta * of.Z[ab][point]};
          if (stiffness.is_zero())
            continue;
          any = true;
          stiffness.add_to(block,
                           LA::RowView(contact.free_rows(a), point).values,
                           row_of_S(a),
                           LA::RowView(contact.free_rows(b), point).values,
                           row_of_S(b));
        }
    return any;
  }
} // namespace Signorini
