// SPDX-License-Identifier: Apache-2.0
#include "contact/constraints/tangents.h"

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Rotate a vector v perpendicular to the unit vector `from` by the smallest rotation that maps
    /// `from` to the unit vector `to` (doc/theory, (3.14)).
    template <int dim>
    Tensor<1, dim>
    rotated(const Tensor<1, dim> &v, const Tensor<1, dim> &from, const Tensor<1, dim> &to)
    {
      constexpr double least = 1e-12;
      // Opposite normals have no unique rotation; the bound avoids the division by zero.
      return v - (to * v) / std::max(1 + from * to, least) * (from + to);
    }
  } // namespace



  // Polar decomposition M = R U of the in-plane part of the deformation gradient (doc/theory,
  // (5.15)).
  template <int dim>
  ConvectedFrame<dim>::ConvectedFrame(const Tensor<1, dim> &normal,
                                      const Tensor<2, dim> &F,
                                      const Tensor<1, dim> &direction)
  {
    // The outward normal of the slave is about -direction: that keeps the orientation.
    const auto         rest = vectors_across(normal), plane = vectors_across(-direction);
    Tensor<2, dim - 1> M; // P F by the vectors of both planes
    for (unsigned int i = 0; i < dim - 1; ++i)
      for (unsigned int j = 0; j < dim - 1; ++j)
        M[i][j] = plane[i] * (F * rest[j]);
    if constexpr (dim == 2)
      {
        stretch = std::abs(M[0][0]);
        vectors = {{M[0][0] > 0 ? plane[0] : -plane[0]}};
      }
    else
      {
        // The rotation by the angle with the tangent skew/sum makes U = R^T M symmetric; the trace
        // of U is the hypotenuse.
        const double sum = M[0][0] + M[1][1], skew = M[1][0] - M[0][1];
        stretch = std::hypot(sum, skew);
        vectors = {{(sum * plane[0] + skew * plane[1]) / stretch,
                    (sum * plane[1] - skew * plane[0]) / stretch}};
      }
  }



  namespace
  {
    /// The deformation gradient F of the surface: it maps the tangents X_a to x_a and the unit
    /// normal N to n. With these as columns, F = [x_a n] [X_a N]^-1.
    template <int dim>
    Tensor<2, dim>
    deformation_of(const FacePatch<dim> &rest, const FacePatch<dim> &now, const Point<dim - 1> &xi)
    {
      const auto     before = rest.tangents(xi), after = now.tangents(xi);
      const auto     N = rest.normal(xi), n = now.normal(xi);
      Tensor<2, dim> columns, images;
      for (unsigned int d = 0; d < dim; ++d)
        {
          for (unsigned int a = 0; a < dim - 1; ++a)
            {
              columns[d][a] = before[a][d];
              images[d][a]  = after[a][d];
            }
          columns[d][dim - 1] = N[d];
          images[d][dim - 1]  = n[d];
        }
      return images * invert(columns);
    }

    /// The components of the vectors E_j, orthonormal and perpendicular to the reference normal, in
    /// terms of the parametric tangents.
    template <int dim>
    std::array<Tensor<1, dim - 1>, dim - 1>
    parameters_of(const FacePatch<dim> &rest, const Point<dim - 1> &xi)
    {
      const auto         tangents = rest.tangents(xi), E = vectors_across(rest.normal(xi));
      Tensor<2, dim - 1> metric;
      for (unsigned int a = 0; a < dim - 1; ++a)
        // E_j = sum_a c^a X_a with c^a = A^ab (X_b . E_j).
        for (unsigned int b = 0; b < dim - 1; ++b)
          metric[a][b] = tangents[a] * tangents[b];
      const Tensor<2, dim - 1>                inverse = invert(metric);
      std::array<Tensor<1, dim - 1>, dim - 1> result;
      for (unsigned int j = 0; j < dim - 1; ++j)
        for (unsigned int a = 0; a < dim - 1; ++a)
          for (unsigned int b = 0; b < dim - 1; ++b)
            result[j][a] += inverse[a][b] * (tangents[b] * E[j]);
      return result;
    }
  } // namespace



  template <int dim>
  std::vector<SurfaceFrame<dim>>
  surface_frames(const BoundaryFaces<dim> &slave, const std::vector<PairedPoint<dim>> &points)
  {
    std::vector<SurfaceFrame<dim>> result;
    result.reserve(points.size());
    for (const auto &[face, xi, weight, master_point, is_beside] : points)
      {
        const FacePatch<dim> &rest = slave.rest[face], &now = slave.patches[face];
        SurfaceFrame<dim>    &frame = result.emplace_back();
        frame.normal                = rest.normal(xi);
        frame.parameters            = parameters_of(rest, xi);
        frame.deformation           = deformation_of(rest, now, xi);
        // The vector from the projection to the slave point, now and at the start of the step: the
        // slip is the change of its tangential part (equation 5.16).
        frame.rigid_motion         = master_point.rigid_motion;
        frame.apart                = now.position(xi) - master_point.position;
        frame.deformation_at_start = frame.deformation; // no slip
        frame.apart_at_start       = frame.apart;
        if (slave.start.empty())
          continue;
        frame.deformation_at_start = deformation_of(rest, slave.start[face], xi);
        frame.apart_at_start       = slave.start[face].position(xi) - master_point.start;
      }
    return result;
  }



  template <int dim>
  Tangents<dim>::Tangents(const ContactRows                      &rows,
                          const std::vector<ContactSurface<dim>> &surfaces,
                          const MPI_Comm                          comm)
  {
    // Mean reference normals of the rows, weighted with the absolute values of their shares, which
    // may be negative with dual functions; ghosted, since points of any rank evaluate them.
    std::vector<LA::Vector> sums(dim, LA::Vector(rows.owned, comm));
    for (unsigned int p = 0; p < surfaces.size(); ++p)
      for (unsigned int q = 0; q < surfaces[p].frames.size(); ++q)
        for (const auto &[row, weight] : rows.shares[p][q])
          for (unsigned int d = 0; d < dim; ++d)
            sums[d](row) += std::abs(weight) * surfaces[p].frames[q].normal[d];
    for (LA::Vector &sum : sums)
      {
        sum.compress(VectorOperation::add);
        normals.emplace_back(rows.owned, rows.writable, comm);
        normals.back() = sum;
      }
  }



  // The mean reference normal of a row, of unit length.
  template <int dim>
  Tensor<1, dim>
  Tangents<dim>::normal(const types::global_dof_index row) const
  {
    Tensor<1, dim> n;
    for (unsigned int d = 0; d < dim; ++d)
      n[d] = normals[d](row);
    return n / n.norm();
  }



  template <int dim>
  typename Tangents<dim>::Frame
  Tangents<dim>::at_rest(const types::global_dof_index row) const
  {
    return vectors_across(normal(row));
  }



  template <int dim>
  typename Tangents<dim>::Frame
  Tangents<dim>::convected(const types::global_dof_index row,
                           const Tensor<1, dim>         &normal_at_rest,
                           const Tensor<2, dim>         &F,
                           const Tensor<1, dim>         &direction) const
  {
    // The fixed vectors of the row, rotated to the normal of the point, have components along the
    // vectors of its tangential plane; the convected vectors have the same components.
    const Tensor<1, dim>      mean = normal(row);
    const Frame               rest = vectors_across(normal_at_rest), of_row = vectors_across(mean);
    const ConvectedFrame<dim> now(normal_at_rest, F, direction);
    Frame                     result;
    for (unsigned int a = 0; a < dim - 1; ++a)
      {
        const Tensor<1, dim> v = rotated(of_row[a], mean, normal_at_rest);
        for (unsigned int j = 0; j < dim - 1; ++j)
          result[a] += (v * rest[j]) * now.vectors[j];
      }
    return result;
  }



  template <int dim>
  typename Tangents<dim>::Frame
  Tangents<dim>::at(const types::global_dof_index row,
                    const SurfaceFrame<dim>      &frame,
                    const Tensor<1, dim>         &direction) const
  {
    return convected(row, frame.normal, frame.deformation, direction);
  }



  template <int dim>
  Tensor<1, dim - 1>
  Tangents<dim>::slip(const types::global_dof_index row,
                      const SurfaceFrame<dim>      &frame,
                      const Tensor<1, dim>         &direction) const
  {
    // The contact normal at the start of the load step: the present one pulled back and pushed
    // forward, as a material vector of the slave.
    Tensor<1, dim> before = frame.deformation_at_start * (invert(frame.deformation) * direction);
    before /= before.norm();
    const Frame now   = at(row, frame, direction),
                start = convected(row, frame.normal, frame.deformation_at_start, before);
    Tensor<1, dim - 1> result;
    for (unsigned int a = 0; a < dim - 1; ++a)
      result[a] = now[a] * frame.apart - start[a] * frame.apart_at_start;
    return result;
  }



#define INSTANTIATE(dim)                                                                           \
  template struct ConvectedFrame<dim>;                                                             \
  template std::vector<SurfaceFrame<dim>> surface_frames(const BoundaryFaces<dim> &,               \
                                                         const std::vector<PairedPoint<dim>> &);   \
  template class Tangents<dim>;
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
