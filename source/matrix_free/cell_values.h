// SPDX-License-Identifier: Apache-2.0
// Values at the nodes of a batch of cells, as many cells as a vector of the processor has lanes,
// and the loop over batches. As lattice_lines.h, this file is included once for each instruction
// set, by the kernels only.

#if defined(SIGNORINI_CELL_VALUES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SIGNORINI_CELL_VALUES_H
#undef SIGNORINI_CELL_VALUES_H
#else
#define SIGNORINI_CELL_VALUES_H
#endif

#include "matrix_free/cell_kernel.h"
#include "matrix_free/lattice_lines.h"

#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace Signorini
{
  namespace HWY_NAMESPACE
  {
    /// Values at the nodes of a batch of cells. The innermost index of all arrays is the cell, so
    /// that each operation is one on a vector register.
    template <typename Number, int nodes>
    struct NodeValues
    {
      using V                      = Lanes<Number>;
      static constexpr int W       = width<Number>;
      static constexpr int n_nodes = nodes;

      /// [component][node or point][cell]
      struct Values
      {
        alignas(64) Number of[3][n_nodes][W];
      };

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

      /// Set the values of all nodes or modes of a batch to zero.
      static HWY_INLINE void
      set_zero(Values &u)
      {
        Number *const at = &u.of[0][0][0];
        for (int k = 0; k < 3 * n_nodes; ++k)
          store(hn::Zero(Tag<Number>()), at + k * W);
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
    };

    /// Implements CellKernel by a loop over batches: gather, apply, scatter.
    /// @tparam Derived has `batches`, with size() and nodes(), and the functions apply(batch, u), u
    /// = K_e u, and diagonal(batch, d)
    /// @tparam Cell CellLattice or CellSimplex
    template <typename Derived, typename Number, typename Cell>
    class CellSweep : public CellKernel<Number>
    {
      using Values = typename Cell::Values;

    public:
      /// dst += K src over all cells of this rank, batch after batch. @param dst,src local arrays
      void
      add_product(Number *dst, const Number *src) const override
      {
        Values u;
        for (std::size_t b = 0; b < derived().batches.size(); ++b)
          {
            Cell::gather(derived().batches.nodes(b), src, u);
            derived().apply(b, u);
            Cell::scatter(derived().batches.nodes(b), u, dst);
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
            Cell::scatter(derived().batches.nodes(b), d, dst);
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
            Cell::enlarge(derived().batches.nodes(b),
                          Cell::eigenvalue(d, [&](Values &u) { derived().apply(b, u); }),
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
