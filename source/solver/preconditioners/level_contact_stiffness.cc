// SPDX-License-Identifier: Apache-2.0
#include "solver/preconditioners/level_contact_stiffness.h"

#include "linear_algebra/columns.h"
#include "linear_algebra/entries.h"
#include "linear_algebra/row_view.h"
#include "linear_algebra/values.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The group of each local row, ascending: that of its slave face, if rows are those of
    /// quadrature points, which are numbered face by face. Rows of nodes are groups of their own,
    /// except for consecutive ones with the same columns.
    std::vector<unsigned int>
    groups_of(const GapOperator &contact)
    {
      const IndexSet           &owned = contact.weight.locally_owned_elements();
      std::vector<unsigned int> groups(owned.n_elements());
      if (!groups.empty() && contact.origin.node.empty())
        {
          unsigned int face = 0;
          for (const SurfacePoints &points : contact.origin.places)
            {
              for (const SurfacePlace &place : points.places)
                groups[owned.index_within_set(place.rows.front().first)] = face;
              ++face;
            }
          Assert(std::is_sorted(groups.begin(), groups.end()), ExcInternalError());
          return groups;
        }
      for (unsigned int row = 1; row < groups.size(); ++row)
        groups[row] =
          groups[row - 1] +
          (LA::RowView(contact.B_free, row).has_columns_of(LA::RowView(contact.B_free, row - 1)) ?
             0 :
             1);
      return groups;
    }

    /// The mean row of each group, weighted with the areas of its points, for each component; rows
    /// of one component follow those of the other.
    LA::SparseMatrix
    mean_gap_rows(const GapOperator               &contact,
                  const std::vector<unsigned int> &groups,
                  const unsigned int               n_groups,
                  const LA::Vector                &group_weight)
    {
      LA::RowBuilder      mean(group_weight.locally_owned_elements(), contact.B_free);
      const double *const points = LA::values_of(contact.weight);
      std::vector<double> sum(LA::global_columns(contact.B_free).size(), 0.);
      std::vector<int>    columns;
      std::vector<double> values;
      for (unsigned int a = 0; a < contact.n_components(); ++a)
        for (unsigned int first = 0, last = 0; first < groups.size(); first = last)
          {
            const double total = LA::values_of(group_weight)[groups[first]];
            columns.clear();
            for (; last < groups.size() && groups[last] == groups[first]; ++last)
              {
                const LA::RowView row(contact.free_rows(a), last);
                for (int k = 0; k < row.size; ++k)
                  if (row.values[k] != 0)
                    {
                      columns.push_back(row.columns[k]);
                      sum[row.columns[k]] += points[last] / total * row.values[k];
                    }
              }
            std::sort(columns.begin(), columns.end());
            columns.erase(std::unique(columns.begin(), columns.end()), columns.end());
            values.clear();
            for (const int column : columns)
              values.push_back(std::exchange(sum[column], 0.));
            mean.add(a * n_groups + groups[first], columns.size(), columns.data(), values.data());
          }
      return mean.finish();
    }

    /// The dense matrix B^T D B over the columns of this rank, for the coarsest level.
    FullMatrix<double>
    local_contact_stiffness(const LA::SparseMatrix &b,
                            const LA::Vector       &D,
                            const unsigned int      n_columns)
    {
      FullMatrix<double> contact_stiffness(n_columns);
      for (unsigned int i = 0; i < D.locally_owned_size(); ++i)
        {
          const double point_stiffness = LA::values_of(D)[i];
          if (point_stiffness == 0)
            continue;
          const LA::RowView row(b, i);
          for (int k = 0; k < row.size; ++k)
            for (int l = 0; l < row.size; ++l)
              contact_stiffness(row.columns[k], row.columns[l]) +=
                point_stiffness * row.values[k] * row.values[l];
        }
      return contact_stiffness;
    }
  } // namespace



  // Rows on all levels, B_(l+1) = B_l P_l (doc/theory, (7.4)), and the limits 6 k W of the groups.
  // Made once for each search; collective.
  LevelContactStiffness::LevelContactStiffness(const Hierarchy   &hierarchy,
                                               const GapOperator &contact)
    : groups(groups_of(contact))
    , n_groups(groups.empty() ? 0 : groups.back() + 1)
  {
    const unsigned int n_components = contact.n_components(), n = n_components * n_groups;
    const MPI_Comm     comm = contact.weight.get_mpi_communicator();
    LA::Vector         weight(LA::contiguous_partition(n, comm), comm);
    limit           = weight;
    D               = weight;
    const double *W = LA::values_of(contact.weight),
                 *k = LA::values_of(contact.coefficients.stiffness);
    for (unsigned int a = 0; a < n_components; ++a)
      for (unsigned int i = 0; i < groups.size(); ++i)
        {
          LA::values_of(weight)[a * n_groups + groups[i]] += W[i];
          LA::values_of(limit)[a * n_groups + groups[i]] += 6. * k[i] * W[i];
        }
    for (unsigned int l = 0; l < hierarchy.n_levels(); ++l)
      levels.push_back(
        std::make_unique<Level>(l == 0 ? mean_gap_rows(contact, groups, n_groups, weight) :
                                         hierarchy.prolongation(l - 1).times(levels[l - 1]->B)));
    gap.resize(n);
  }



  // The contact stiffness of a group is the sum over its points, at most its limit.
  void
  LevelContactStiffness::set(const PointVectors &contact_stiffness)
  {
    remove();
    for (unsigned int a = 0; a < contact_stiffness.size(); ++a)
      {
        double *const       d    = LA::values_of(D) + a * n_groups;
        const double *const most = LA::values_of(limit) + a * n_groups;
        for (unsigned int i = 0; i < groups.size(); ++i)
          d[groups[i]] =
            std::min(d[groups[i]] + LA::values_of(contact_stiffness[a])[i], most[groups[i]]);
      }
    update_levels();
  }



  // For estimates of eigenvalues, which must hold for any active set (doc/theory, 7.1).
  void
  LevelContactStiffness::stiffen()
  {
    D = limit;
    update_levels();
  }



  void
  LevelContactStiffness::remove()
  {
    D = 0.;
    update_levels();
  }



  void
  LevelContactStiffness::update_levels()
  {
    is_any = D.linfty_norm() > 0;
  }



  // Add diagonal entries, or sums of absolute values of rows, of B^T D B of a level. Collective.
  void
  LevelContactStiffness::add_contact_stiffness(const Level  &level,
                                               const Entries entries,
                                               float        *result) const
  {
    if (!is_any)
      return;
    std::vector<float> of_columns(level.single_precision.n_columns(), 0.f);
    for (unsigned int i = 0; i < D.locally_owned_size(); ++i)
      {
        const LA::RowView row(level.B, i);
        double            sum = 0;
        for (int k = 0; k < row.size; ++k)
          sum += std::abs(row.values[k]);
        for (int k = 0; k < row.size; ++k)
          {
            const double size = std::abs(row.values[k]);
            of_columns[row.columns[k]] +=
              LA::values_of(D)[i] * size * (entries == Entries::all ? sum : size);
          }
      }
    level.single_precision.add_columns(of_columns.data(), result);
  }



  void
  LevelContactStiffness::add_diagonal(const unsigned int level, float *result) const
  {
    add_contact_stiffness(*levels[level], Entries::diagonal, result);
  }



  void
  LevelContactStiffness::add_row_sums(const unsigned int level, float *result) const
  {
    add_contact_stiffness(*levels[level], Entries::all, result);
  }



  // B to gaps, D to forces, B^T to the degrees of freedom, in single precision with one exchange in
  // each direction. Collective.
  void
  LevelContactStiffness::add_product(const unsigned int level, float *dst, const float *src) const
  {
    if (!is_any)
      return;
    const LA::LevelMatrix &B = levels[level]->single_precision;
    B.vmult(gap.data(), src);
    for (std::size_t i = 0; i < gap.size(); ++i)
      gap[i] *= LA::values_of(D)[i];
    B.Tvmult_add(dst, gap.data());
  }



  // Rows of B have few columns on the coarsest level, so that a dense block is added to K.
  // Collective.
  LA::SparseMatrix
  LevelContactStiffness::sum_with_contact_stiffness(const LA::SparseMatrix &K,
                                                    const unsigned int      level) const
  {
    const LA::SparseMatrix                    &B       = levels[level]->B;
    const std::vector<types::global_dof_index> columns = LA::global_columns(B);
    return LA::sum(K, local_contact_stiffness(B, D, columns.size()), columns);
  }
} // namespace Signorini
