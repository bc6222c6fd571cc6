// SPDX-License-Identifier: Apache-2.0
// Operations of the kernels on the nodes and quadrature points of a batch of hexahedra, as many
// cells as a vector of the processor has lanes. As lattice_lines.h, this file is included once for
// each instruction set, by the kernels only.

#if defined(SIGNORINI_CELL_LATTICE_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SIGNORINI_CELL_LATTICE_H
#undef SIGNORINI_CELL_LATTICE_H
#else
#define SIGNORINI_CELL_LATTICE_H
#endif

#include "matrix_free/cell_values.h"
#include "matrix_free/kernel_tables.h"

#include <utility>

HWY_BEFORE_NAMESPACE();
namespace Signorini
{
  namespace HWY_NAMESPACE
  {
    /// The tensor product lattice of the (degree + 1)^3 nodes, and of as many Gauss points, of a
    /// batch of hexahedra.
    template <typename Number, int of_degree>
    struct CellLattice : NodeValues<Number, (of_degree + 1) * (of_degree + 1) * (of_degree + 1)>
    {
      using Base = NodeValues<Number, (of_degree + 1) * (of_degree + 1) * (of_degree + 1)>;
      using Base::n_nodes;
      using Base::W;
      using typename Base::Values;

      static constexpr bool   is_simplex  = false;
      static constexpr int    degree      = of_degree;
      static constexpr int    n           = degree + 1;
      static constexpr int    n_points    = n_nodes;
      static constexpr Number unit_volume = 1; ///< of the reference cell

      /// [component][direction][point][cell]
      struct Gradients
      {
        alignas(64) Number of[3][3][n_points][W];
      };

      const KernelTables<Number, degree>        tables;
      static constexpr Legendre<Number, degree> legendre{};

      /// Gradients in reference coordinates at the Gauss points, from nodal values u, which are
      /// overwritten. First the values at the Gauss points along each direction, then derivatives
      /// of the polynomials through these: six contractions for each component instead of nine.
      HWY_INLINE void
      evaluate_gradients(Values &u, Gradients &g) const
      {
        for (int c = 0; c < 3; ++c)
          {
            Number *at = &u.of[c][0][0];
            contract<0, false, false>(tables.values, at, at);
            contract<1, false, false>(tables.values, at, at);
            contract<2, false, false>(tables.values, at, at);
            // Derivatives along each direction of the polynomials through the Gauss points, of
            // which the values are known now. The last three contractions read the same values.
            contract<0, false, false>(tables.derivatives, at, &g.of[c][0][0][0]);
            contract<1, false, false>(tables.derivatives, at, &g.of[c][1][0][0]);
            contract<2, false, false>(tables.derivatives, at, &g.of[c][2][0][0]);
          }
      }

      /// The transpose of evaluate_gradients(): nodal values u = sum over points of gradients of
      /// the shape functions times g.
      HWY_INLINE void
      integrate_gradients(const Gradients &g, Values &u) const
      {
        for (int c = 0; c < 3; ++c)
          {
            Number *at = &u.of[c][0][0];
            contract<0, true, false>(tables.derivatives, &g.of[c][0][0][0], at);
            // The first product overwrites the values, the other two are added.
            contract<1, true, true>(tables.derivatives, &g.of[c][1][0][0], at);
            contract<2, true, true>(tables.derivatives, &g.of[c][2][0][0], at);
            contract<0, true, false>(tables.values, at, at);
            contract<1, true, false>(tables.values, at, at);
            contract<2, true, false>(tables.values, at, at);
          }
      }

      /// The Gauss weight of a point on the unit cube.
      HWY_INLINE Number
      unit_weight(const int q) const
      {
        return tables.weights[q % n] * tables.weights[q / n % n] * tables.weights[q / (n * n)];
      }

      /// The gradient in reference coordinates of the shape function of node i at point q.
      HWY_INLINE void
      unit_gradient(const int q, const int i, Number (&gradient)[3]) const
      {
        const int at[3]   = {q % n, q / n % n, q / (n * n)};
        const int node[3] = {i % n, i / n % n, i / (n * n)};
        for (int d = 0; d < 3; ++d)
          {
            // The derivative of a nodal polynomial is that of the polynomial through its values at
            // the Gauss points, so that both tables of the sum factorisation suffice.
            gradient[d] = 0;
            for (int k = 0; k < n; ++k)
              gradient[d] += tables.derivatives[at[d]][k] * tables.values[k][node[d]];
            for (int e = 0; e < 3; ++e)
              if (e != d)
                gradient[d] *= tables.values[at[e]][node[e]];
          }
      }

      /// Transform nodal values to coefficients of L_T = L_i(2 xi - 1) L_j(2 eta - 1) L_k(2 zeta -
      /// 1) with Legendre polynomials L. The derivative in direction d maps coefficients to
      /// coefficients: that of L_T comes from the next higher degree in that direction, at T +
      /// mode_stride(d).
      static HWY_INLINE void
      to_all_modes(Values &u)
      {
        for (int c = 0; c < 3; ++c)
          {
            Number *of_c = &u.of[c][0][0];
            to_modes<0, n>(of_c, of_c);
            to_modes<1, n>(of_c, of_c);
            to_modes<2, n>(of_c, of_c);
          }
      }

      /// The transpose of to_all_modes(): nodal forces from forces on the coefficients f, which are
      /// overwritten.
      static HWY_INLINE void
      from_all_modes(Values &f, Values &u)
      {
        for (int c = 0; c < 3; ++c)
          {
            Number *of_c = &f.of[c][0][0];
            from_modes<2, n>(of_c, of_c);
            from_modes<1, n>(of_c, of_c);
            from_modes<0, n>(of_c, &u.of[c][0][0]);
          }
      }

      /// The distance in the arrays between modes whose degrees in a direction differ by one.
      static constexpr int
      mode_stride(const int direction)
      {
        return direction == 0 ? 1 : direction == 1 ? n : n * n;
      }

      /// Degree of mode T in a direction.
      static constexpr int
      mode_degree(const int T, const int direction)
      {
        return T / mode_stride(direction) % n;
      }

      /// int L_T^2 over the unit cell, for coefficients as to_all_modes() gives them.
      static HWY_INLINE Number
      mode_weight(const int T)
      {
        return legendre.weights[mode_degree(T, 0)] * legendre.weights[mode_degree(T, 1)] *
               legendre.weights[mode_degree(T, 2)];
      }

      /// Call kernel.template add_mode<T>(modes) for all T that occur in derivatives, which the
      /// mode of highest degree in all directions does not. For degree two each call is a function
      /// of its own: inlined in one function, 26 of them take minutes to compile and are slower.
      template <typename Kernel, typename Modes>
      static HWY_INLINE void
      add_modes(const Kernel &kernel, Modes &modes)
      {
        add_modes(kernel, modes, std::make_integer_sequence<int, n_nodes - 1>());
      }

    private:
      /// add_mode<T>() as a function of its own, see add_modes().
      template <int T, typename Kernel, typename Modes>
      static HWY_NOINLINE void
      add_mode_apart(const Kernel &kernel, Modes &modes)
      {
        kernel.template add_mode<T>(modes);
      }

      template <typename Kernel, typename Modes, int... T>
      static HWY_INLINE void
      add_modes(const Kernel &kernel, Modes &modes, std::integer_sequence<int, T...>)
      {
        if constexpr (degree == 1)
          (kernel.template add_mode<T>(modes), ...);
        else
          (add_mode_apart<T>(kernel, modes), ...);
      }
    };
  } // namespace HWY_NAMESPACE
} // namespace Signorini
HWY_AFTER_NAMESPACE();

#endif
