// SPDX-License-Identifier: Apache-2.0
#include "contact/traction/normal_stress.h"

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    using Indices = std::vector<types::global_dof_index>;

    /// Sort and remove repeated indices.
    void
    sort_and_remove_duplicates(Indices &indices)
    {
      std::sort(indices.begin(), indices.end());
      indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
    }

    /// The position of an index in a sorted list that has it.
    unsigned int
    position_in(const Indices &indices, const types::global_dof_index i)
    {
      return std::lower_bound(indices.begin(), indices.end(), i) - indices.begin();
    }

    /// The components of displacement on which gaps of these points depend; all of them, if
    /// inclined supports may couple components, or the image of the master is rotated.
    template <int dim>
    Components
    components_of(const std::vector<ContactPoint<dim>> &points,
                  const unsigned int                    first,
                  const unsigned int                    last,
                  const bool                            all)
    {
      Components result;
      result.fill(all);
      for (unsigned int q = first; q < last; ++q)
        for (unsigned int d = 0; d < dim; ++d)
          result[d] = result[d] || points[q].direction[d] != 0 || points[q].turn;
      return result;
    }

    /// Add the rows of the slip at a point (doc/theory, (3.13)), times the shares of the rows of
    /// its area.
    /// @param rows positions of the rows in the matrix, one for each share
    template <int dim>
    void
    add_slip(const ContactPoint<dim>         &point,
             const SurfaceFrame<dim>         &frame,
             const Tangents<dim>             &tangents,
             const std::vector<Share>        &shares,
             const std::vector<unsigned int> &rows,
             FaceMatrix                      &matrix)
    {
      for (unsigned int i = 0; i < shares.size(); ++i)
        {
          const auto frame_of_row = tangents.at(shares[i].row, frame, point.direction);
          // Slave minus master, along the tangents that the row has at this point.
          for (const double sign : {1., -1.})
            {
              auto along = frame_of_row;
              for (unsigned int a = 0; a < dim - 1 && sign < 0; ++a)
                along[a] = point.on_master(frame_of_row[a]);
              for (const NodeShapeFunction<dim> &function : sign > 0 ? point.slave : point.master)
                for (unsigned int d = 0; d < dim; ++d)
                  {
                    const unsigned int j = position_in(matrix.columns, function.node + d);
                    for (unsigned int a = 0; a < dim - 1; ++a)
                      matrix.slip[a](rows[i], j) +=
                        shares[i].weight * sign * function.value * along[a][d];
                  }
            }
          for (unsigned int d = 0; d < dim; ++d)
            for (const auto &[column, value] : frame.rigid_motion[d])
              {
                const unsigned int j = position_in(matrix.columns, column);
                for (unsigned int a = 0; a < dim - 1; ++a)
                  matrix.slip[a](rows[i], j) -= shares[i].weight * value * frame_of_row[a][d];
              }
        }
    }

    /// Add the rows of the stress at point q of a surface, as of add_slip().
    template <int dim>
    void
    add_stress(const ContactSurface<dim>       &surface,
               const unsigned int               q,
               const Tangents<dim>             *tangents,
               const std::vector<Share>        &shares,
               const std::vector<unsigned int> &rows,
               FaceMatrix                      &matrix)
    {
      for (unsigned int i = 0; i < shares.size(); ++i)
        for_each_stress(surface,
                        q,
                        tangents,
                        shares[i].row,
                        [&](const unsigned int a, const StressRow &row, const double factor) {
                          for (const auto &[column, value] : row.displacement)
                            matrix.stress[a](rows[i], position_in(matrix.columns, column)) +=
                              shares[i].weight * factor * value;
                        });
    }

    /// The dense matrices of the points first to last - 1 of a surface, which are on one slave
    /// face: for each row and column the sum of share times entry, of displacement, stress and
    /// slip. Not collective.
    template <int dim>
    FaceMatrix
    face_matrix(const ContactSurface<dim>             &surface,
                const std::vector<std::vector<Share>> &shares,
                const Tangents<dim>                   *tangents,
                const Components                      &components,
                const unsigned int                     first,
                const unsigned int                     last)
    {
      // Rows and columns of all points first, then the entries. Nodes of consecutive points are
      // mostly the same.
      FaceMatrix matrix;
      for (unsigned int q = first; q < last; ++q)
        {
          for (const Share &share : shares[q])
            matrix.rows.push_back(share.row);
          const ContactPoint<dim> &point = surface.points[q];
          if (q == first || !same_nodes(surface.points[q - 1], point))
            for (const auto *functions : {&point.slave, &point.master})
              for (const NodeShapeFunction<dim> &function : *functions)
                for (unsigned int d = 0; d < dim; ++d)
                  if (components[d])
                    matrix.columns.push_back(function.node + d);
          for (const auto &entry : point.rigid)
            matrix.columns.push_back(entry.first);
          for (const StressRow &component : point.stress)
            for (const auto &entry : component.displacement)
              matrix.columns.push_back(entry.first);
          if (tangents)
            for (const SparseRow &component : surface.frames[q].rigid_motion)
              for (const auto &entry : component)
                matrix.columns.push_back(entry.first);
        }
      sort_and_remove_duplicates(matrix.rows);
      sort_and_remove_duplicates(matrix.columns);
      // Either all points of a surface have rows of the stress, or none has: it depends on the
      // method.
      matrix.displacement.reinit(matrix.rows.size(), matrix.columns.size());
      matrix.stress.assign(surface.points[first].stress.size(),
                           FullMatrix<double>(matrix.rows.size(), matrix.columns.size()));
      if (tangents)
        matrix.slip.assign(dim - 1, FullMatrix<double>(matrix.rows.size(), matrix.columns.size()));
      std::vector<unsigned int> rows;
      for (unsigned int q = first; q < last; ++q)
        {
          rows.clear();
          for (const Share &share : shares[q])
            rows.push_back(position_in(matrix.rows, share.row));
          const auto add_to = [&](FullMatrix<double> &values) {
            return [&](const types::global_dof_index column, const double value) {
              const unsigned int j = position_in(matrix.columns, column);
              for (unsigned int i = 0; i < rows.size(); ++i)
                values(rows[i], j) += shares[q][i].weight * value;
            };
          };
          for_each_entry(surface.points[q], components, add_to(matrix.displacement));
          add_stress(surface, q, tangents, shares[q], rows, matrix);
          if (tangents)
            add_slip(surface.points[q], surface.frames[q], *tangents, shares[q], rows, matrix);
        }
      return matrix;
    }
  } // namespace



  template <int dim>
  std::vector<FaceMatrix>
  face_matrices(const ContactRows                      &rows,
                const std::vector<ContactSurface<dim>> &surfaces,
                const Sampling                          sampling,
                const Tangents<dim>                    *tangents,
                const bool                              all_components)
  {
    std::vector<FaceMatrix> matrices;
    for (unsigned int p = 0; p < surfaces.size(); ++p)
      {
        const auto &points = surfaces[p].points;
        for (unsigned int first = 0, last = 0; first < points.size(); first = last)
          {
            // Points of one face form a group. With one row for each point a group ends where the
            // nodes change, since the row has the columns of its own projection only.
            while (last < points.size() && points[last].face == points[first].face &&
                   (sampling == Sampling::nodes || same_nodes(points[first], points[last])))
              ++last;
            const auto components =
              components_of(points, first, last, all_components || tangents != nullptr);
            matrices.push_back(
              face_matrix(surfaces[p], rows.shares[p], tangents, components, first, last));
          }
      }
    return matrices;
  }



  template std::vector<FaceMatrix>
  face_matrices(const ContactRows &,
                const std::vector<ContactSurface<2>> &,
                Sampling,
                const Tangents<2> *,
                bool);
  template std::vector<FaceMatrix>
  face_matrices(const ContactRows &,
                const std::vector<ContactSurface<3>> &,
                Sampling,
                const Tangents<3> *,
                bool);
} // namespace Signorini
