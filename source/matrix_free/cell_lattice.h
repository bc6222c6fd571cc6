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

#include "matrix_free/cell_kernel.h"
#include "matrix_free/kernel_tables.h"
#include "matrix_free/lattice_lines.h"

#include <type_traits>
#include <utility>

HWY_BEFORE_NAMESPACE();
namespace Signorini
{
  namespace HWY_NAMESPACE
  {
    /// The tensor product lattice of the (degree + 1)^3 nodes, and of as many Gauss points, of a
    /// batch of cells. The innermost index of all arrays is the cell, so that each operation is one
    /// on a vector register.
    template <typename Number, int degree>
    struct CellLattice
    {
      using V                      = Lanes<Number>;
      static constexpr int W       = width<Number>;
      static constexpr int n       = degree + 1;
      static constexpr int n_nodes = n * n * n;

      /// [component][node or point][cell]
      struct Values
      {
        alignas(64) Number of[3][n_nodes][W];
      };

      /// [component][direction][point][cell]
      struct Gradients
      {
        alignas(64) Number of[3][3][n_nodes][W];
      };

      const KernelTables<Number, degree>        tables;
      static constexpr Legendre<Number, degree> legendre{};

      /// Read the values of the nodes of a batch from a vector of this rank.
      /// @param slot position of the first component of each node: [node][cell]
      /// @param src may be read one element beyond its last one
      static HWY_INLINE void
      gather(const std::uint32_t *slot, const Number *HWY_RESTRICT src, Values &u)
      {
#if HWY_TARGET != HWY_SCALAR
        if constexpr (std::is_same<Number, float>::value)
          {
            for (int i = 0; i < n_nodes; ++i)
              gather_nodes(slot + i * W, src, u.of[0][i], u.of[1][i], u.of[2][i]);
            return;
          }
#endif
        for (int i = 0; i < n_nodes; ++i)
          for (int w = 0; w < W; ++w)
            {
              const Number *at = src + slot[i * W + w];
              u.of[0][i][w]    = at[0];
              u.of[1][i][w]    = at[1];
              u.of[2][i][w]    = at[2];
            }
      }

      /// Add values at the nodes of a batch to a vector, cell by cell, since cells of a batch may
      /// share nodes. Cells that only fill up a batch have zero weight and add nothing.
      static HWY_INLINE void
      scatter(const std::uint32_t *slot, const Values &u, Number *HWY_RESTRICT dst)
      {
        for (int i = 0; i < n_nodes; ++i)
          for (int w = 0; w < W; ++w)
            {
              Number *at = dst + slot[i * W + w];
              at[0] += u.of[0][i][w];
              at[1] += u.of[1][i][w];
              at[2] += u.of[2][i][w];
            }
      }

      /// Raise the elements of dst at the nodes of each cell to the value of the cell, if they are
      /// smaller.
      static void
      enlarge(const std::uint32_t *slot, const V value, Number *dst)
      {
        alignas(64) Number largest[W];
        store(value, largest);
        for (int k = 0; k < n_nodes * W; ++k)
          for (int c = 0; c < 3; ++c)
            dst[slot[k] + c] = HWY_MAX(dst[slot[k] + c], largest[k % W]);
      }

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

      /// Set the values of all nodes or modes of a batch to zero.
      static HWY_INLINE void
      set_zero(Values &u)
      {
        Number *const at = &u.of[0][0][0];
        for (int k = 0; k < 3 * n_nodes; ++k)
          store(hn::Zero(Tag<Number>()), at + k * W);
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

      /// The largest eigenvalue of D^-1 K_e of each cell, by eight steps of power iteration from an
      /// oscillating vector; the Rayleigh quotient (u.Ku)/(u.Du) of the last step.
      /// @param d diagonals D of the cells
      /// @param apply performs u = K_e u
      template <typename Apply>
      static HWY_INLINE V
      eigenvalue(const Values &d, const Apply &apply)
      {
        constexpr int       n_steps = 8;
        Values              u, Ku;
        const Number *const of_d = &d.of[0][0][0];
        Number *const of_u = &u.of[0][0][0], *const of_Ku = &Ku.of[0][0][0];
        // A start vector that varies from node to node without any symmetry.
        for (int k = 0; k < 3 * n_nodes; ++k)
          store(all(Number((k * 7919) % 13) - Number(6.25)), of_u + k * W);
        V       quotient = hn::Zero(Tag<Number>());
        const V tiny     = all(Number(1e-30));
        for (int step = 0; step < n_steps; ++step)
          {
            // u <- D^-1 K_e u, scaled so that the largest element is one.
            Ku = u;
            apply(Ku);
            V energy = hn::Zero(Tag<Number>()), norm = tiny, next = tiny;
            for (int k = 0; k < 3 * n_nodes; ++k)
              {
                const V x = load(of_u + k * W), f = load(of_Ku + k * W), D = load(of_d + k * W);
                energy    = hn::MulAdd(x, f, energy);
                norm      = hn::MulAdd(hn::Mul(D, x), x, norm);
                const V y = hn::Div(f, hn::Max(D, tiny));
                next      = hn::Max(next, hn::Abs(y));
                store(y, of_u + k * W);
              }
            quotient = hn::Div(energy, norm);
            for (int k = 0; k < 3 * n_nodes; ++k)
              store(hn::Div(load(of_u + k * W), next), of_u + k * W);
          }
        return quotient;
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

    /// Implements CellKernel by a loop over batches: gather, apply, scatter.
    /// @tparam Derived has `batches`, with size() and nodes(), and the functions apply(batch, u), u
    /// = K_e u, and diagonal(batch, d)
    template <typename Derived, typename Number, int degree>
    class CellSweep : public CellKernel<Number>
    {
      using Lattice = CellLattice<Number, degree>;
      using Values  = typename Lattice::Values;

    public:
      /// dst += K src over all cells of this rank, batch after batch. @param dst,src local arrays
      void
      add_product(Number *dst, const Number *src) const override
      {
        Values u;
        for (std::size_t b = 0; b < derived().batches.size(); ++b)
          {
            Lattice::gather(derived().batches.nodes(b), src, u);
            derived().apply(b, u);
            Lattice::scatter(derived().batches.nodes(b), u, dst);
          }
      }

      /// dst += the diagonals of the element matrices.
      void
      add_diagonal(Number *dst) const override
      {
        Values d;
        for (std::size_t b = 0; b < derived().batches.size(); ++b)
          {
            derived().diagonal(b, d);
            Lattice::scatter(derived().batches.nodes(b), d, dst);
          }
      }

      /// Raise each element of dst to the largest eigenvalue of D^-1 K_e of the cells around it.
      void
      enlarge_by_eigenvalues(Number *dst) const override
      {
        Values d;
        for (std::size_t b = 0; b < derived().batches.size(); ++b)
          {
            derived().diagonal(b, d);
            Lattice::enlarge(derived().batches.nodes(b),
                             Lattice::eigenvalue(d, [&](Values &u) { derived().apply(b, u); }),
                             dst);
          }
      }

      std::size_t
      memory_consumption() const override
      {
        return derived().batches.memory_consumption();
      }

    private:
      const Derived &
      derived() const
      {
        return static_cast<const Derived &>(*this);
      }
    };
  } // namespace HWY_NAMESPACE
} // namespace Signorini
HWY_AFTER_NAMESPACE();

#endif
