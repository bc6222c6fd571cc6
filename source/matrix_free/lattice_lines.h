// SPDX-License-Identifier: Apache-2.0
// Operations on vector registers along the lines of a lattice of nodes or points, for kernels that
// Highway compiles once for each instruction set: this file is included once for each of them, by
// matrix_free/cell_kernel.cc and the like only.

#if defined(SIGNORINI_LATTICE_LINES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SIGNORINI_LATTICE_LINES_H
#undef SIGNORINI_LATTICE_LINES_H
#else
#define SIGNORINI_LATTICE_LINES_H
#endif

#include <hwy/highway.h>

#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace Signorini
{
  namespace HWY_NAMESPACE
  {
    namespace hn = hwy::HWY_NAMESPACE;

    /// Vectors with one lane for each cell of a batch, and their number of lanes.
    template <typename Number>
    using Tag = hn::ScalableTag<Number>;
    template <typename Number>
    using Lanes = hn::Vec<Tag<Number>>;
    template <typename Number>
    constexpr int width = hn::MaxLanes(Tag<Number>());

    /// Load the lanes of a vector from aligned memory.
    template <typename Number>
    HWY_INLINE Lanes<Number>
               load(const Number *from)
    {
      return hn::Load(Tag<Number>(), from);
    }

    /// Store the lanes of a vector to aligned memory.
    template <typename Number>
    HWY_INLINE void
    store(const Lanes<Number> x, Number *to)
    {
      hn::Store(x, Tag<Number>(), to);
    }

    /// The same number in all lanes.
    template <typename Number>
    HWY_INLINE Lanes<Number>
               all(const Number x)
    {
      return hn::Set(Tag<Number>(), x);
    }

#if HWY_TARGET != HWY_SCALAR
    /// Load blocks of four consecutive numbers, one from each of as many slots as a vector has
    /// blocks.
    template <typename D, int n_blocks = hn::MaxLanes(D()) / 4>
    HWY_INLINE hn::Vec<D>
               load_blocks(const D d, const std::uint32_t *slot, const float *from)
    {
      if constexpr (n_blocks == 1)
        return hn::LoadU(d, from + slot[0]);
      else
        {
          const hn::Half<D> half;
          return hn::Combine(d,
                             load_blocks(half, slot + 2 * n_blocks, from),
                             load_blocks(half, slot, from));
        }
    }

    /// Gather the components x, y, z of nodes from the slots of their first components, by
    /// transposing blocks of four. Reads one number beyond the last component.
    HWY_INLINE void
    gather_nodes(const std::uint32_t *slot, const float *from, float *x, float *y, float *z)
    {
      const Tag<float>   d;
      const Lanes<float> v0 = load_blocks(d, slot, from), v1 = load_blocks(d, slot + 1, from),
                         v2 = load_blocks(d, slot + 2, from), v3 = load_blocks(d, slot + 3, from);
      const Lanes<float> xy02 = hn::InterleaveLower(d, v0, v2),
                         xy13 = hn::InterleaveLower(d, v1, v3),
                         zw02 = hn::InterleaveUpper(d, v0, v2),
                         zw13 = hn::InterleaveUpper(d, v1, v3);
      store(hn::InterleaveLower(d, xy02, xy13), x);
      store(hn::InterleaveUpper(d, xy02, xy13), y);
      store(hn::InterleaveLower(d, zw02, zw13), z);
    }
#endif

    /// The distance in an n x n x n lattice from one point of a line along a direction to the next.
    template <int direction, int n, typename Number>
    constexpr int line_stride = width<Number> *(direction == 0 ? 1 :
                                                direction == 1 ? n :
                                                                 n * n);

    /// The position of the first point of a line along a direction; lines are numbered from 0 to
    /// n^2 - 1.
    template <int direction, int n, typename Number>
    HWY_INLINE int
    first_of_line(const int line)
    {
      return width<Number> * (direction == 0 ? line * n :
                              direction == 1 ? line % n + line / n * n * n :
                                               line);
    }

    /// Apply a matrix along all lines of one direction of an n x n x n lattice: out(q) = sum_i M(q,
    /// i) in(i), or M(i, q) in(i) if transposed; added to `out` if `add`. `in` may be `out`.
    template <int direction, bool transposed, bool add, int n, typename Number>
    HWY_INLINE void
    contract(const Number (&M)[n][n], const Number *in, Number *out)
    {
      constexpr int stride = line_stride<direction, n, Number>;
      for (int line = 0; line < n * n; ++line)
        {
          // The line is in registers before its first result is stored, so that it may be
          // overwritten.
          const int     first = first_of_line<direction, n, Number>(line);
          Lanes<Number> x[n];
          for (int i = 0; i < n; ++i)
            x[i] = load(in + first + i * stride);
          for (int q = 0; q < n; ++q)
            {
              Lanes<Number> sum = add ? load(out + first + q * stride) : hn::Zero(Tag<Number>());
              for (int i = 0; i < n; ++i)
                sum = hn::MulAdd(x[i], all(transposed ? M[i][q] : M[q][i]), sum);
              store(sum, out + first + q * stride);
            }
        }
    }

    /// From values at nodes -1, (0,) 1 along all lines of a direction to coefficients of Legendre's
    /// polynomials: 2, 2 times those of degree 1; 6, 2, 3 times those of degree 2. `in` may be
    /// `out`.
    template <int direction, int n, typename Number>
    HWY_INLINE void
    to_modes(const Number *in, Number *out)
    {
      constexpr int stride = line_stride<direction, n, Number>;
      for (int line = 0; line < n * n; ++line)
        {
          const int           at  = first_of_line<direction, n, Number>(line);
          const Lanes<Number> low = load(in + at), high = load(in + at + (n - 1) * stride),
                              sum = hn::Add(low, high);
          if constexpr (n == 2)
            store(sum, out + at);
          else
            {
              const Lanes<Number> middle = load(in + at + stride);
              store(hn::MulAdd(all(Number(4)), middle, sum), out + at);
              store(hn::NegMulAdd(all(Number(2)), middle, sum), out + at + 2 * stride);
            }
          store(hn::Sub(high, low), out + at + stride);
        }
    }

    /// The transposed of that.
    template <int direction, int n, typename Number>
    HWY_INLINE void
    from_modes(const Number *in, Number *out)
    {
      constexpr int stride = line_stride<direction, n, Number>;
      for (int line = 0; line < n * n; ++line)
        {
          const int           at     = first_of_line<direction, n, Number>(line);
          const Lanes<Number> zeroth = load(in + at), first = load(in + at + stride);
          Lanes<Number>       even = zeroth;
          if constexpr (n == 3)
            {
              const Lanes<Number> second = load(in + at + 2 * stride);
              even                       = hn::Add(zeroth, second);
              store(hn::MulSub(all(Number(4)), zeroth, hn::Add(second, second)), out + at + stride);
            }
          store(hn::Sub(even, first), out + at);
          store(hn::Add(even, first), out + at + (n - 1) * stride);
        }
    }
  } // namespace HWY_NAMESPACE
} // namespace Signorini
HWY_AFTER_NAMESPACE();

#endif
