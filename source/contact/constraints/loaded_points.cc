// SPDX-License-Identifier: Apache-2.0
#include "contact/constraints/geometric_stiffness.h"
#include "contact/constraints/tangents.h"

#include <deal.II/lac/full_matrix.h>

#include <optional>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// A vector at a point of a face, and its derivatives with respect to the face parameters.
    template <int dim>
    struct ValueAndSlopes
    {
      Tensor<1, dim>                      value;
      std::array<Tensor<1, dim>, dim - 1> slopes;
    };

    /// The displacement at a point. @param u values by slot, see LoadedPoint
    template <int dim>
    ValueAndSlopes<dim>
    evaluate(const FaceShapeFunctions<dim> &functions, const double *u)
    {
      ValueAndSlopes<dim> at;
      for (const NodeShapeFunction<dim> &function : functions)
        for (unsigned int d = 0; d < dim; ++d)
          {
            const double of_node = u[function.node + d];
            at.value[d] += function.value * of_node;
            for (unsigned int a = 0; a < dim - 1; ++a)
              at.slopes[a][d] += function.slopes[a] * of_node;
          }
      return at;
    }

    /// The transpose of evaluate(). @param force conjugate to the displacement and its derivatives
    template <int dim>
    void
    distribute(const FaceShapeFunctions<dim> &functions,
               const ValueAndSlopes<dim>     &force,
               double                        *dst)
    {
      for (const NodeShapeFunction<dim> &function : functions)
        for (unsigned int d = 0; d < dim; ++d)
          {
            double sum = function.value * force.value[d];
            for (unsigned int a = 0; a < dim - 1; ++a)
              sum += function.slopes[a] * force.slopes[a][d];
            dst[function.node + d] += sum;
          }
    }
  } // namespace



  // The rows R_i of a point applied to a vector, in the order: directions . (u^S - u^M), with the
  // rigid rows of obstacles added; then the slopes of the master along of_master, and of the slave
  // along of_slave.
  template <int dim>
  void
  LoadedPoint<dim>::evaluate_rows(const double *u, std::vector<double> &R) const
  {
    // Obstacles have no nodes, so that the jump is that of the slave; their motion enters by the
    // rigid rows.
    const ValueAndSlopes<dim> of_S = evaluate(slave, u), of_M = evaluate(master, u);
    const Tensor<1, dim>      jump = of_S.value - of_M.value;
    R.assign(n_rows(), 0.);
    for (unsigned int i = 0; i < directions.size(); ++i)
      R[i] = directions[i] * jump;
    for (unsigned int i = 0; i < rigid.size(); ++i)
      for (const auto &[slot, value] : rigid[i])
        R[i] += value * u[slot];
    unsigned int next = n_jumps();
    for (const Tensor<1, dim> &direction : of_master)
      for (const Tensor<1, dim> &slope : of_M.slopes)
        R[next++] = direction * slope;
    for (const auto &vectors : of_slave)
      {
        for (unsigned int a = 0; a < dim - 1; ++a)
          R[next] += vectors[a] * of_S.slopes[a];
        ++next;
      }
  }



  // The transpose of evaluate_rows(): dst += sum_i s_i R_i.
  template <int dim>
  void
  LoadedPoint<dim>::add_rows(const std::vector<double> &s, double *dst) const
  {
    ValueAndSlopes<dim> on_S, on_M;
    for (unsigned int i = 0; i < directions.size(); ++i)
      on_S.value += s[i] * directions[i];
    on_M.value = -on_S.value;
    for (unsigned int i = 0; i < rigid.size(); ++i)
      for (const auto &[slot, value] : rigid[i])
        dst[slot] += value * s[i];
    unsigned int next = n_jumps();
    for (const Tensor<1, dim> &direction : of_master)
      for (Tensor<1, dim> &slope : on_M.slopes)
        slope += s[next++] * direction;
    for (const auto &vectors : of_slave)
      {
        for (unsigned int a = 0; a < dim - 1; ++a)
          on_S.slopes[a] += s[next] * vectors[a];
        ++next;
      }
    distribute(slave, on_S, dst);
    distribute(master, on_M, dst);
  }



  namespace
  {
    /// The loaded point of a contact pressure: the second variation (5.7) or (5.14) times the force
    /// (doc/theory, (5.9)).
    /// @param force pressure times area [force]
    template <int dim>
    LoadedPoint<dim>
    pressed(const FaceShapeFunctions<dim> &slave,
            const FaceShapeFunctions<dim> &master,
            const Tensor<1, dim>          &normal,
            const GapSecondVariation<dim> &second_variation,
            const double                   force)
    {
      LoadedPoint<dim> point{slave,
                             master,
                             second_variation.directions,
                             second_variation.rigid,
                             {},
                             {},
                             second_variation.factors};
      if (second_variation.rigid.empty())
        point.of_master.push_back(normal);
      for (double &factor : point.factors)
        factor *= force;
      return point;
    }

    /// Copy a dense matrix to the factors of a point.
    template <int dim>
    void
    set_factors(const FullMatrix<double> &C, LoadedPoint<dim> &point)
    {
      point.factors.clear();
      for (unsigned int i = 0; i < C.m(); ++i)
        for (unsigned int j = 0; j < C.n(); ++j)
          point.factors.push_back(C(i, j));
    }

    /// Add the rotation of the material of the slave about n (5.18), only in space: in the plane
    /// the tangent rotates with n alone. The point gets a row for the slopes of the slave.
    /// @param T tangential force at the point
    /// @param contravariant the components of a vector along the directions of the rows w
    /// @param w number of the first of these rows
    /// @param spin number of the row of the slopes
    /// @param add_dn adds row i times v.dn times a factor, called as add_dn(i, v, factor)
    template <int dim, typename Components, typename AddNormalChange>
    void
    add_rotation_of_slave(const Tensor<1, dim>    &T,
                          const Tensor<1, dim>    &n,
                          const SurfaceFrame<dim> &frame,
                          const Components        &contravariant,
                          const unsigned int       w,
                          const unsigned int       spin,
                          const AddNormalChange   &add_dn,
                          FullMatrix<double>      &C,
                          LoadedPoint<dim>        &point)
    {
      if constexpr (dim == 3)
        {
          const ConvectedFrame<3> frame_now(frame.normal, frame.deformation, n);
          const auto             &tau     = frame_now.vectors;
          const auto              E       = vectors_across(frame.normal);
          const Tensor<1, 3>      rotated = (T * tau[0]) * tau[1] - (T * tau[1]) * tau[0];
          const Tensor<1, 2>      by_w    = contravariant(rotated) / frame_now.stretch;
          point.of_slave.emplace_back();
          for (unsigned int a = 0; a < 2; ++a)
            {
              C(w + a, spin) += by_w[a];
              add_dn(w + a, tau[1], -by_w[a] * (n * (frame.deformation * E[0])));
              add_dn(w + a, tau[0], by_w[a] * (n * (frame.deformation * E[1])));
              point.of_slave.back()[a] =
                frame.parameters[0][a] * tau[1] - frame.parameters[1][a] * tau[0];
            }
        }
      else
        (void)T, (void)n, (void)frame, (void)contravariant, (void)w, (void)spin, (void)add_dn,
          (void)C, (void)point;
    }

    /// Add the contribution of a tangential traction (doc/theory, (5.17)) to a point between bodies
    /// that has that of the pressure. The rows become
    ///
    ///   y_a.(uS - uM), n.(uS - uM), n.uM,a, T.uM,a, and in space tau_2.uS,1 - tau_1.uS,2,
    ///
    /// and the matrix C of their products is in general not symmetric.
    /// @param T tangential force at the point: traction times area [force]
    template <int dim>
    void
    add_tangential(const Tensor<1, dim>          &T,
                   const Tensor<1, dim>          &n,
                   const GapSecondVariation<dim> &second_variation,
                   const SurfaceFrame<dim>       &frame,
                   LoadedPoint<dim>              &point)
    {
      constexpr unsigned int m = dim - 1, w = 0, jump = m, n_M = m + 1, T_M = 2 * m + 1,
                             spin = 3 * m + 1, size = 3 * m + 1 + (dim == 3 ? 1 : 0);
      const auto &y = second_variation.directions;
      // The matrices A, H^-1 and A^-1 K H^-1 of (5.5) and (5.6) are recovered from the factors of
      // second_variation_of_bodies().
      Tensor<2, m> A, G, AKG; // metric, H^-1, A^-1 K H^-1
      for (unsigned int a = 0; a < m; ++a)
        for (unsigned int b = 0; b < m; ++b)
          {
            A[a][b]   = y[a] * y[b];
            G[a][b]   = -second_variation.factors[a * 2 * m + m + b];
            AKG[a][b] = -second_variation.factors[a * 2 * m + b];
          }
      const double       gap       = -second_variation.factors[m * 2 * m + m] / G[0][0];
      const Tensor<2, m> inverse   = invert(A);
      const auto         covariant = [&](const Tensor<1, dim> &v) {
        Tensor<1, m> result;
        for (unsigned int a = 0; a < m; ++a)
          result[a] = v * y[a];
        return result;
      };

      // The factors of the pressure, moved by one row: the normal jump is inserted after the
      // tangential ones.
      FullMatrix<double> C(size, size);
      const auto         slot = [&](const unsigned int i) { return i < m ? i : i + 1; };
      // Rows w, n.u_M,a of the pressure: the latter come after the normal jump, which the traction
      // needs in addition.
      for (unsigned int a = 0; a < 2 * m; ++a)
        for (unsigned int b = 0; b < 2 * m; ++b)
          C(slot(a), slot(b)) = point.factors[a * 2 * m + b];
      // Add row i times v . dn for a vector v tangential to the master, with dn of (5.6).
      const auto add_dn = [&](const unsigned int i, const Tensor<1, dim> &v, const double factor) {
        const Tensor<1, m> v_a = covariant(v), v_b = inverse * v_a, by_dxi = transpose(AKG) * v_a;
        for (unsigned int b = 0; b < m; ++b)
          {
            C(i, n_M + b) -= factor * (v_b[b] + gap * by_dxi[b]);
            C(i, w + b) -= factor * by_dxi[b];
          }
      };

      // First term of (5.17): -(T . dn) n.(vS - vM); then the change of the closest point, -dxi_b
      // T.vM,b.
      add_dn(jump, T, -1);
      for (unsigned int b = 0; b < m; ++b)
        for (unsigned int c = 0; c < m; ++c)
          {
            C(T_M + b, w + c) -= G[b][c];
            C(T_M + b, n_M + c) -= gap * G[b][c];
          }
      point.directions.push_back(n);
      point.of_master.push_back(T);
      const auto contravariant = [&](const Tensor<1, dim> &v) { return inverse * covariant(v); };
      add_rotation_of_slave(T, n, frame, contravariant, w, spin, add_dn, C, point);
      set_factors(C, point);
    }

    /// The same against an obstacle, with the rows t_a.w, n.w, the spins s_i, and in space
    /// tau_2.uS,1 - tau_1.uS,2, where w is the displacement relative to the obstacle and t_a are
    /// its tangents; dn = Q w + s x n (doc/theory, (5.14)). What the spin of an obstacle changes in
    /// the direction of its own motion is left out: that concerns obstacles under given moments
    /// only, and there only the rate of convergence.
    /// @param rigid normal motion of the obstacle at the point, over its degrees of freedom
    template <int dim>
    void
    add_tangential_against_obstacle(const Tensor<1, dim>          &T,
                                    const Tensor<1, dim>          &n,
                                    const SparseRow               &rigid,
                                    const GapSecondVariation<dim> &second_variation,
                                    const SurfaceFrame<dim>       &frame,
                                    LoadedPoint<dim>              &point)
    {
      constexpr unsigned int m = dim - 1, jump = m;
      const unsigned int     old = second_variation.rigid.size(), spin = old + 1,
                         size     = old + 1 + (dim == 3 ? 1 : 0);
      const auto        &tangents = second_variation.directions;
      const auto         slot     = [&](const unsigned int i) { return i < m ? i : i + 1; };
      FullMatrix<double> C(size, size);
      for (unsigned int i = 0; i < old; ++i)
        for (unsigned int j = 0; j < old; ++j)
          C(slot(i), slot(j)) = point.factors[i * old + j];
      // Row a of the second variation is t_a . dn.
      const auto add_dn = [&](const unsigned int i, const Tensor<1, dim> &v, const double factor) {
        for (unsigned int a = 0; a < m; ++a)
          for (unsigned int j = 0; j < old; ++j)
            C(i, slot(j)) += factor * (v * tangents[a]) * second_variation.factors[a * old + j];
      };
      add_dn(jump, T, -1);
      point.directions.push_back(n);
      SparseRow normal_motion = rigid;
      for (auto &entry : normal_motion)
        entry.second *= -1;
      point.rigid.insert(point.rigid.begin() + m, normal_motion);
      const auto components = [&](const Tensor<1, dim> &v) {
        Tensor<1, m> result;
        for (unsigned int a = 0; a < m; ++a)
          result[a] = v * tangents[a];
        return result;
      };
      add_rotation_of_slave(T, n, frame, components, 0, spin, add_dn, C, point);
      set_factors(C, point);
    }

    /// The forces at points of integration, from the tractions of rows: sums over the shares of a
    /// point.
    template <int dim>
    class TractionsAtPoints
    {
    public:
      /// Keeps copies of the tractions with ghost values. Collective.
      TractionsAtPoints(const ContactRows                      &rows,
                        const std::vector<ContactSurface<dim>> &surfaces,
                        const PointVectors                     &traction,
                        const MPI_Comm                          comm)
      {
        for (const LA::Vector &component : traction)
          {
            // A point may have shares of rows that other ranks own.
            components.emplace_back(rows.owned, rows.writable, comm);
            components.back() = component;
          }
        if (traction.size() > 1)
          tangents.emplace(rows, surfaces, comm);
      }

      /// The normal force at a point: pressure times area.
      double
      pressure(const std::vector<Share> &shares) const
      {
        double sum = 0;
        for (const auto &[row, weight] : shares)
          sum += weight * components[0](row);
        return sum;
      }

      /// The tangential force at a point: traction times area. @param n contact normal
      Tensor<1, dim>
      tangential(const std::vector<Share> &shares,
                 const SurfaceFrame<dim>  &frame,
                 const Tensor<1, dim>     &n) const
      {
        Tensor<1, dim> sum;
        for (const auto &[row, weight] : shares)
          {
            const auto tau = tangents->at(row, frame, n);
            for (unsigned int a = 0; a < dim - 1; ++a)
              sum += weight * components[a + 1](row) * tau[a];
          }
        return sum;
      }

      bool
      has_tangential() const
      {
        return tangents.has_value();
      }

    private:
      PointVectors                 components;
      std::optional<Tangents<dim>> tangents;
    };
  } // namespace



  template <int dim>
  std::vector<LoadedPoint<dim>>
  loaded_points(const std::vector<ContactSurface<dim>> &surfaces,
                const ContactRows                      &rows,
                const PointVectors                     &traction,
                const MPI_Comm                          comm)
  {
    // Open points, and points without second variation, are left out: the cost of a product is
    // proportional to the points under load.
    const TractionsAtPoints<dim>  tractions(rows, surfaces, traction, comm);
    std::vector<LoadedPoint<dim>> result;
    for (unsigned int s = 0; s < surfaces.size(); ++s)
      {
        const ContactSurface<dim> &surface = surfaces[s];
        for (unsigned int q = 0; q < surface.points.size(); ++q)
          {
            const ContactPoint<dim>  &point  = surface.points[q];
            const Tensor<1, dim>     &n      = point.direction;
            const std::vector<Share> &shares = rows.shares[s][q];
            const double              force  = tractions.pressure(shares);
            Tensor<1, dim>            T;
            if (tractions.has_tangential())
              T = tractions.tangential(shares, surface.frames[q], n);
            if ((force == 0 && T.norm_square() == 0) || point.second_variation.factors.empty())
              continue;
            result.push_back(pressed(point.slave, point.master, n, point.second_variation, force));
            // The second variation against obstacles has other factors, see GapSecondVariation.
            if (T.norm_square() > 0 && point.master.empty())
              add_tangential_against_obstacle(
                T, n, point.rigid, point.second_variation, surface.frames[q], result.back());
            else if (T.norm_square() > 0)
              add_tangential(T, n, point.second_variation, surface.frames[q], result.back());
          }
        for (unsigned int q = 0; q < surface.edge_points.size(); ++q)
          {
            const EdgeContactPoint<dim> &edge_point = surface.edge_points[q];
            const std::vector<Share>    &shares     = rows.edge_point_shares[s][q];
            const double                 force      = tractions.pressure(shares);
            if (edge_point.second_variation.factors.empty())
              continue;
            // The end of the segment moves by v.(uM - uS), see second_variation_of_edge().
            const Tensor<1, dim> &n = edge_point.second_variation.directions[0],
                                 &v = edge_point.second_variation.directions[1];
            // Pressure: half of the symmetrised product, (5.8), times the force.
            if (force != 0)
              {
                const double half = force * edge_point.second_variation.factors[1];
                result.push_back(
                  {edge_point.slave, edge_point.master, {n, v}, {}, {}, {}, {0., half, half, 0.}});
              }
            // Tangential traction: -(T . [v]) (v . [u]), which is not symmetric.
            if (!tractions.has_tangential())
              continue;
            const Tensor<1, dim> T = tractions.tangential(shares, surface.edge_point_frames[q], n);
            if (T.norm_square() > 0)
              result.push_back(
                {edge_point.slave, edge_point.master, {T, v}, {}, {}, {}, {0., -1., 0., 0.}});
          }
      }
    return result;
  }



#define INSTANTIATE(dim)                                                                           \
  template struct LoadedPoint<dim>;                                                                \
  template std::vector<LoadedPoint<dim>> loaded_points(const std::vector<ContactSurface<dim>> &,   \
                                                       const ContactRows &,                        \
                                                       const PointVectors &,                       \
                                                       MPI_Comm);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
