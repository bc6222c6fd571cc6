#include <signorini/contact/discretisation/geometric_stiffness.h>
#include <signorini/linear_algebra/diagonal.h>
#include <signorini/linear_algebra/sparsity_pattern.h>

#include <deal.II/lac/full_matrix.h>

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// What a contact point adds.
    struct PointMatrix
    {
      std::vector<types::global_dof_index> indices;
      FullMatrix<double>                   values;
    };

    /// sum_ij C_ij T_i T_j^T
    template <int dim>
    PointMatrix
    point_matrix(const ContactPoint<dim> &point, const double force)
    {
      const unsigned int m = point.bend_rows.size();
      PointMatrix        result;
      for (const SparseRow &row : point.bend_rows)
        for (const auto &entry : row)
          result.indices.push_back(entry.first);
      auto &indices = result.indices;
      std::sort(indices.begin(), indices.end());
      indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
      const auto number = [&](const types::global_dof_index i) {
        return std::lower_bound(indices.begin(), indices.end(), i) - indices.begin();
      };
      FullMatrix<double> T(m, indices.size()), C(m, m);
      for (unsigned int i = 0; i < m; ++i)
        {
          for (const auto &[index, value] : point.bend_rows[i])
            T(i, number(index)) += value;
          for (unsigned int j = 0; j < m; ++j)
            C(i, j) = force * point.bend_factors[i * m + j];
        }
      // By rows, most of whose entries are zero.
      const unsigned int  n = indices.size();
      std::vector<double> CT(n);
      result.values.reinit(n, n);
      for (unsigned int a = 0; a < m; ++a)
        {
          std::fill(CT.begin(), CT.end(), 0.);
          for (unsigned int b = 0; b < m; ++b)
            for (unsigned int j = 0; j < n; ++j)
              CT[j] += C(a, b) * T(b, j);
          for (unsigned int i = 0; i < n; ++i)
            if (const double factor = T(a, i); factor != 0)
              for (unsigned int j = 0; j < n; ++j)
                result.values(i, j) += factor * CT[j];
        }
      return result;
    }
  } // namespace



  template <int dim>
  LA::SparseMatrix
  geometric_stiffness(const Elasticity<dim>                  &elasticity,
                      const std::vector<ContactSurface<dim>> &surfaces,
                      const ContactRows                      &rows,
                      const LA::Vector                       &pressure)
  {
    const MPI_Comm comm = elasticity.mesh().communicator();
    LA::Vector     p(rows.owned, rows.writable, comm);
    p = pressure;
    std::vector<PointMatrix> matrices;
    for (unsigned int s = 0; s < surfaces.size(); ++s)
      for (unsigned int q = 0; q < surfaces[s].points.size(); ++q)
        {
          double force = 0;
          for (const auto &[row, weight] : rows.shares[s][q])
            force += weight * p(row);
          if (force == 0 || surfaces[s].points[q].bend_rows.empty())
            continue;
          PointMatrix matrix = point_matrix(surfaces[s].points[q], force);
          // Points between the same two faces.
          if (!matrices.empty() && matrices.back().indices == matrix.indices)
            matrices.back().values.add(1, matrix.values);
          else
            matrices.push_back(std::move(matrix));
        }

    // Rows of other ranks too: those of the masters.
    const IndexSet                      &owned    = elasticity.owned();
    IndexSet                             writable = owned;
    std::vector<types::global_dof_index> foreign;
    for (const PointMatrix &matrix : matrices)
      foreign.insert(foreign.end(), matrix.indices.begin(), matrix.indices.end());
    std::sort(foreign.begin(), foreign.end());
    writable.add_indices(foreign.begin(), foreign.end());
    LA::SparsityPattern pattern(owned, owned, writable, comm, 0u);
    for (const PointMatrix &matrix : matrices)
      for (const auto row : matrix.indices)
        pattern.add_entries(row, matrix.indices.begin(), matrix.indices.end(), true);
    pattern.compress();
    LA::SparseMatrix result;
    result.reinit(pattern);
    for (const PointMatrix &matrix : matrices)
      result.add(matrix.indices, matrix.values);
    result.compress(VectorOperation::add);
    // A rank does not know what is prescribed on others.
    LA::Vector free = elasticity.zero_vector();
    free            = 1.;
    elasticity.constraints().set_zero(free);
    LA::scale_rows(result, free);
    LA::scale_columns(result, free);
    return result;
  }



  template LA::SparseMatrix
  geometric_stiffness(const Elasticity<2> &,
                      const std::vector<ContactSurface<2>> &,
                      const ContactRows &,
                      const LA::Vector &);
  template LA::SparseMatrix
  geometric_stiffness(const Elasticity<3> &,
                      const std::vector<ContactSurface<3>> &,
                      const ContactRows &,
                      const LA::Vector &);
} // namespace Signorini
