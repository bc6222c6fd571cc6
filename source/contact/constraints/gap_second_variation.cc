// SPDX-License-Identifier: Apache-2.0
#include "contact/constraints/gap_second_variation.h"

#include "contact/search/vectors_across.h"

#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The coefficients C of a second variation, n x n, row by row; symmetric by set().
    class Factors
    {
    public:
      explicit Factors(const unsigned int n)
        : n(n)
        , values(n * n, 0.)
      {}

      void
      set(const unsigned int i, const unsigned int j, const double value)
      {
        values[i * n + j] = values[j * n + i] = value;
      }

      const unsigned int  n;
      std::vector<double> values;
    };

    /// n . (s x t) for the unit spin s about axis i (2D: about the axis out of the plane).
    template <int dim>
    double
    rotated(const unsigned int i, const Tensor<1, dim> &t, const Tensor<1, dim> &n)
    {
      if constexpr (dim == 2)
        return (void)i, n[1] * t[0] - n[0] * t[1];
      else
        return cross_product_3d(t, n)[i];
    }

    /// The mean of n . (s x (s' x r)) and n . (s' x (s x r)) for the unit spins s about axis i and
    /// s' about axis j.
    template <int dim>
    double
    rotated_twice(const unsigned int    i,
                  const unsigned int    j,
                  const Tensor<1, dim> &r,
                  const Tensor<1, dim> &n)
    {
      if constexpr (dim == 2)
        return (void)i, (void)j, -(n * r);
      else
        return (n[i] * r[j] + n[j] * r[i]) / 2 - (i == j ? n * r : 0.);
    }
  } // namespace



  // On the rank of the master face: tangents, metric and curvature at the projection.
  template <int dim>
  GapSecondVariation<dim>
  second_variation_of_master(const FacePatch<dim> &patch,
                             const Point<dim - 1> &xi,
                             const Tensor<1, dim> &n)
  {
    // Until the slave point is known, the factors hold the metric A and the curvatures K = n . y_ab
    // of the master; second_variation_of_bodies() replaces them.
    const auto              geometry   = patch.at(xi, 2);
    const auto             &tangents   = geometry.tangents;
    const auto             &curvatures = geometry.curvatures;
    GapSecondVariation<dim> second_variation;
    second_variation.directions.assign(tangents.begin(), tangents.end());
    for (const auto &row : tangents)
      for (const auto &column : tangents)
        second_variation.factors.push_back(row * column);
    for (const auto &row : curvatures)
      for (const auto &second : row)
        second_variation.factors.push_back(n * second);
    return second_variation;
  }



  // On the rank of the slave point: the factors of (5.7) from metric, curvature and gap.
  template <int dim>
  GapSecondVariation<dim>
  second_variation_of_bodies(const Point<dim> &x, const MasterProjection<dim> &master_point)
  {
    constexpr unsigned int  m      = dim - 1;
    const Tensor<1, dim>    arm    = x - master_point.position;
    const double            gap    = arm * master_point.normal;
    GapSecondVariation<dim> result = master_point.second_variation;
    // No second variation: the master is not displaced, or the point is too far to carry pressure.
    if (result.factors.empty())
      return result;
    Tensor<2, m> A, K;
    for (unsigned int a = 0; a < m; ++a)
      {
        const Tensor<1, dim> &tangent = result.directions[a];
        // The projection is on the rim of a face, not normal to it: (5.6) does not hold there.
        if (std::abs(arm * tangent) > 1e-6 * tangent.norm_square())
          return {};
        for (unsigned int b = 0; b < m; ++b)
          {
            A[a][b] = result.factors[a * m + b];
            K[a][b] = result.factors[m * m + a * m + b];
          }
      }
    // Formula (5.7): -A^-1 K H^-1 for w w, -H^-1 for w m and m w, -g H^-1 for m m, with H = A - g
    // K.
    const Tensor<2, m> H = A - gap * K, G = invert(H), AKH = invert(A) * K * G;
    Factors            C(2 * m);
    for (unsigned int a = 0; a < m; ++a)
      for (unsigned int b = 0; b < m; ++b)
        {
          C.values[a * C.n + b]           = -AKH[a][b];
          C.values[(m + a) * C.n + m + b] = -gap * G[a][b];
          C.set(a, m + b, -G[a][b]);
        }
    result.factors = C.values;
    return result;
  }



  // A segment edge that moves with the master face, see (5.8).
  template <int dim>
  GapSecondVariation<dim>
  second_variation_of_edge(const Tensor<1, dim> &n, const Tensor<1, dim> &v)
  {
    GapSecondVariation<dim> second_variation;
    second_variation.directions = {n, v};
    // The symmetric part of -(n.[v]) (nu.[u]) for each of the two segments at an edge, (5.8).
    Factors C(second_variation.n_rows());
    C.set(0, 1, -0.5);
    second_variation.factors = C.values;
    return second_variation;
  }



  // A rigid obstacle (doc/theory, (5.14)): its curvature at the projection couples the
  // displacements along the surface, and spins about the reference point, if it moves, couple with
  // both.
  template <int dim>
  GapSecondVariation<dim>
  second_variation_of_obstacle(const ObstaclePoint<dim>     &obstacle_point,
                               const RigidPose<dim>         &pose,
                               const Point<dim>             &x,
                               const types::global_dof_index first_dof)
  {
    const Tensor<1, dim> &n        = obstacle_point.normal;
    const Tensor<1, dim>  r        = pose.arm(x);
    const auto            tangents = vectors_across(n);
    const bool            moves    = first_dof != numbers::invalid_dof_index;
    // Formula (5.14) by rows of w along the tangents (the Hessian Q has no normal part) and of the
    // spins.
    const unsigned int      m = dim - 1, spins = moves ? pose.n_rotations : 0;
    GapSecondVariation<dim> second_variation;
    Factors                 C(m + spins);
    const auto              add_row = [&](const auto &values, const double sign) {
      second_variation.rigid.emplace_back();
      for (unsigned int i = 0; moves && i < values.size(); ++i)
        if (values[i] != 0)
          second_variation.rigid.back().emplace_back(first_dof + i, sign * values[i]);
    };
    second_variation.directions.assign(tangents.begin(), tangents.end());
    for (unsigned int a = 0; a < m; ++a)
      {
        // w is the displacement of the slave relative to the obstacle: rigid rows have the opposite
        // sign.
        add_row(pose.row(x, tangents[a]), -1);
        for (unsigned int b = 0; b <= a; ++b)
          C.set(a, b, tangents[a] * (obstacle_point.curvature * tangents[b]));
      }
    for (unsigned int i = 0; i < spins; ++i)
      {
        add_row(pose.spin(i), 1);
        for (unsigned int a = 0; a < m; ++a)
          C.set(a, m + i, -rotated(i, tangents[a], n));
        for (unsigned int j = 0; j <= i; ++j)
          C.set(m + i, m + j, -rotated_twice(i, j, r, n));
      }
    second_variation.factors = C.values;
    return second_variation;
  }



#define INSTANTIATE(dim)                                                                           \
  template GapSecondVariation<dim> second_variation_of_master(const FacePatch<dim> &,              \
                                                              const Point<dim - 1> &,              \
                                                              const Tensor<1, dim> &);             \
  template GapSecondVariation<dim> second_variation_of_bodies(const Point<dim> &,                  \
                                                              const MasterProjection<dim> &);      \
  template GapSecondVariation<dim> second_variation_of_edge(const Tensor<1, dim> &,                \
                                                            const Tensor<1, dim> &);               \
  template GapSecondVariation<dim> second_variation_of_obstacle(const ObstaclePoint<dim> &,        \
                                                                const RigidPose<dim> &,            \
                                                                const Point<dim> &,                \
                                                                types::global_dof_index);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
