// SPDX-License-Identifier: Apache-2.0
// This file is compiled once for each instruction set, as cell_kernel.cc.

#include "matrix_free/tangent_kernel.h"

#include "matrix_free/batches.h"
#include "matrix_free/instruction_sets.h"
#include "matrix_free/targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "matrix_free/tangent_kernel.cc"
// clang-format off
#include <hwy/foreach_target.h> // first
#include <hwy/highway.h>
#include "matrix_free/cell_lattice.h"
#include "matrix_free/cell_simplex.h"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace Signorini
{
  namespace HWY_NAMESPACE
  {
    namespace hn = hwy::HWY_NAMESPACE;

    /// Load tangents, which are stored in single precision for both precisions of the products.
    template <typename Number>
    HWY_INLINE Lanes<Number>
               load_single_precision(const float *from)
    {
      if constexpr (std::is_same<Number, float>::value)
        return load(from);
      else
        return hn::PromoteTo(Tag<double>(), hn::Load(hn::Rebind<float, Tag<double>>(), from));
    }

    /// At a point replace the gradient by its product with a tangent.
    /// @param g [component][direction][point][cell]
    template <typename Number, int n, int W>
    HWY_INLINE void
    to_stress(const float *const tangent, const int q, Number (&g)[3][3][n][W])
    {
      Lanes<Number> G[9];
      for (int m = 0; m < 9; ++m)
        G[m] = load(g[m / 3][m % 3][q]);
#pragma GCC unroll 9
      for (int m = 0; m < 9; ++m)
        {
          Lanes<Number> sum = hn::Zero(Tag<Number>());
#pragma GCC unroll 9
          for (int k = 0; k < 9; ++k)
            sum = hn::MulAdd(load_single_precision<Number>(tangent + tangent_number(m, k) * W),
                             G[k],
                             sum);
          store(sum, g[m / 3][m % 3][q]);
        }
    }

    /// Products with one tangent for each cell, integrated over it (in reference coordinates, with
    /// weights), in Legendre polynomials, or by the gradients at vertices of tetrahedra: for
    /// multigrid levels, in single precision.
    template <typename Number, typename Cell>
    class MeanTangentKernel final : public CellSweep<MeanTangentKernel<Number, Cell>, Number, Cell>
    {
    public:
      explicit MeanTangentKernel(const KernelCells &cells)
        : batches(cells, W)
      // Integrals for diagonals; the tangents have the volume of the reference cell in them.
      {
        for (int i = 0; i < n_nodes; ++i)
          for (int d = 0; d < 3; ++d)
            for (int e = 0; e < 3; ++e)
              {
                products[i][d][e] = 0;
                for (int q = 0; q < n_points; ++q)
                  {
                    Number gradient[3];
                    reference.unit_gradient(q, i, gradient);
                    products[i][d][e] +=
                      reference.unit_weight(q) / Cell::unit_volume * gradient[d] * gradient[e];
                  }
              }
      }

    private:
      using Values                  = typename Cell::Values;
      using V                       = typename Cell::V;
      static constexpr int W        = Cell::W;
      static constexpr int n_nodes  = Cell::n_nodes;
      static constexpr int n_points = Cell::n_points;
      static constexpr int degree   = Cell::degree;
      friend Cell;
      friend CellSweep<MeanTangentKernel, Number, Cell>;

      struct Modes
      {
        const Values &u;
        Values        f;
        const float  *tangent;
      };

      HWY_INLINE void
      apply(const std::size_t b, Values &u) const
      {
        if constexpr (Cell::is_simplex)
          {
            // Stresses are linear as gradients are.
            typename Cell::VertexGradients g;
            Cell::evaluate_at_vertices(u, g);
            for (int v = 0; v < Cell::n_vertices; ++v)
              to_stress<Number>(batches.tangent(b, 0), v, g.of);
            Cell::average(g);
            Cell::integrate_from_vertices(g, u);
          }
        else
          apply_to_modes(b, u);
      }

      HWY_INLINE void
      apply_to_modes(const std::size_t b, Values &u) const
      {
        // To coefficients in Legendre polynomials, the contribution of each polynomial of the
        // gradient, and back by the transposed transformation.
        Modes modes{u, {}, batches.tangent(b, 0)};
        Cell::to_all_modes(u);
        Cell::set_zero(modes.f);
        Cell::add_modes(*this, modes);
        Cell::from_all_modes(modes.f, u);
      }

      /// Add to f the gradient's component along L_T, see Kernel::add_mode().
      template <int T>
      HWY_INLINE void
      add_mode(Modes &modes) const
      {
        constexpr int i[3]      = {Cell::mode_degree(T, 0),
                                   Cell::mode_degree(T, 1),
                                   Cell::mode_degree(T, 2)};
        constexpr int stride[3] = {Cell::mode_stride(0),
                                   Cell::mode_stride(1),
                                   Cell::mode_stride(2)};
        const V       weight    = all(Cell::mode_weight(T));
        // The nine coefficients of du_c/dxi_d along L_T: the derivative in direction d of the
        // polynomial that has one degree more in that direction. Polynomials of the highest degree
        // have no such neighbour; the coefficient is zero, and is skipped here and below.
        V G[9];
        for (int c = 0; c < 3; ++c)
          for (int d = 0; d < 3; ++d)
            if (i[d] < degree)
              G[3 * c + d] = hn::Mul(load(modes.u.of[c][T + stride[d]]),
                                     hn::Mul(weight, all(Cell::legendre.derivatives[i[d]])));
        for (int c = 0; c < 3; ++c)
          for (int d = 0; d < 3; ++d)
            if (i[d] < degree)
              {
                V sum = hn::Zero(Tag<Number>());
                for (int m = 0; m < 9; ++m)
                  // The stress of component (c, d) is the row 3 c + d of the mean tangent times the
                  // gradient. It is tested by the same derivative, so that the matrix of the cell
                  // is symmetric.
                  if (i[m % 3] < degree)
                    sum = hn::MulAdd(load_single_precision<Number>(
                                       modes.tangent + tangent_number(3 * c + d, m) * W),
                                     G[m],
                                     sum);
                Number *f = modes.f.of[c][T + stride[d]];
                store(hn::MulAdd(sum, all(Cell::legendre.derivatives[i[d]]), load(f)), f);
              }
      }

      void
      diagonal(const std::size_t b, Values &diagonal) const
      {
        // A diagonal entry tests a function with itself: of the tangent only the 3 x 3 block of the
        // same component c is needed, weighted with the integrals of products of derivatives.
        const float *const tangent = batches.tangent(b, 0);
        for (int i = 0; i < n_nodes; ++i)
          for (int c = 0; c < 3; ++c)
            {
              V sum = hn::Zero(Tag<Number>());
              for (int d = 0; d < 3; ++d)
                for (int e = 0; e < 3; ++e)
                  sum = hn::MulAdd(load_single_precision<Number>(
                                     tangent + tangent_number(3 * c + d, 3 * c + e) * W),
                                   all(products[i][d][e]),
                                   sum);
              store(sum, diagonal.of[c][i]);
            }
      }

      const Cell           reference;
      const TangentBatches batches;

      /// int dN_i/dxi_d dN_i/dxi_e over the unit cell: [node][d][e].
      Number products[n_nodes][3][3];
    };

    /// Products with one tangent for each quadrature point, or the moments of tetrahedra: the
    /// consistent tangent of Newton's method at finite strain.
    template <typename Number, typename Cell>
    class PointTangentKernel final
      : public CellSweep<PointTangentKernel<Number, Cell>, Number, Cell>
    {
    public:
      explicit PointTangentKernel(const KernelCells &cells)
        : batches(cells, W)
      {}

    private:
      using Values                  = typename Cell::Values;
      using V                       = typename Cell::V;
      static constexpr int W        = Cell::W;
      static constexpr int n_nodes  = Cell::n_nodes;
      static constexpr int n_points = Cell::n_points;
      static constexpr int degree   = Cell::degree;
      friend Cell;
      friend CellSweep<PointTangentKernel, Number, Cell>;

      HWY_INLINE void
      apply(const std::size_t b, Values &u) const
      {
        // Geometry and quadrature weights are in the tangents, so that the kernel has no data of
        // the mesh.
        if constexpr (Cell::is_simplex)
          return apply_moments(b, u);
        else
          apply_at_points(b, u);
      }

      /// Stresses integrated with the functions of the vertices, by the moments of the tangent.
      HWY_INLINE void
      apply_moments(const std::size_t b, Values &u) const
      {
        typename Cell::VertexGradients g, s;
        Cell::evaluate_at_vertices(u, g);
        for (int m = 0; m < 9; ++m)
          for (int v = 0; v < Cell::n_vertices; ++v)
            store(hn::Zero(Tag<Number>()), s.of[m / 3][m % 3][v]);
        for (int v = 0; v < Cell::n_vertices; ++v)
          for (int w = 0; w <= v; ++w)
            add_moment(batches.tangent(b, SimplexTables<Number, degree>::moment(v, w)), v, w, g, s);
        Cell::integrate_from_vertices(s, u);
      }

      /// Add the moment of the vertices v and w to the stresses of both.
      template <typename VertexGradients>
      static HWY_INLINE void
      add_moment(const float *const     tangent,
                 const int              v,
                 const int              w,
                 const VertexGradients &g,
                 VertexGradients       &s)
      {
        V of_v[9], of_w[9];
        for (int m = 0; m < 9; ++m)
          {
            of_v[m] = load(g.of[m / 3][m % 3][v]);
            of_w[m] = load(g.of[m / 3][m % 3][w]);
          }
          // Unrolled, so that the places of the numbers are constants.
#pragma GCC unroll 9
        for (int m = 0; m < 9; ++m)
          {
            V to_v = load(s.of[m / 3][m % 3][v]), to_w = hn::Zero(Tag<Number>());
#pragma GCC unroll 9
            for (int k = 0; k < 9; ++k)
              {
                const V number = load_single_precision<Number>(tangent + tangent_number(m, k) * W);
                to_v           = hn::MulAdd(number, of_w[k], to_v);
                to_w           = hn::MulAdd(number, of_v[k], to_w);
              }
            store(to_v, s.of[m / 3][m % 3][v]);
            if (v != w)
              store(hn::Add(to_w, load(s.of[m / 3][m % 3][w])), s.of[m / 3][m % 3][w]);
          }
      }

      /// Gradients in reference coordinates at all points, the stress of each point in place of its
      /// gradient, and the transposed evaluation.
      HWY_INLINE void
      apply_at_points(const std::size_t b, Values &u) const
      {
        typename Cell::Gradients g;
        reference.evaluate_gradients(u, g);
        for (int q = 0; q < n_points; ++q)
          to_stress<Number>(batches.tangent(b, q), q, g.of);
        reference.integrate_gradients(g, u);
      }

      void
      diagonal(const std::size_t b, Values &diagonal) const
      {
        for (int i = 0; i < n_nodes; ++i)
          {
            V sum[3] = {hn::Zero(Tag<Number>()), hn::Zero(Tag<Number>()), hn::Zero(Tag<Number>())};
            if constexpr (Cell::is_simplex)
              {
                for (int v = 0; v < Cell::n_vertices; ++v)
                  for (int w = 0; w <= v; ++w)
                    {
                      Number at_v[3], at_w[3];
                      Cell::unit_gradient_at_vertex(v, i, at_v);
                      Cell::unit_gradient_at_vertex(w, i, at_w);
                      add_to_diagonal(batches.tangent(b,
                                                      SimplexTables<Number, degree>::moment(v, w)),
                                      v == w ? 1 : 2,
                                      at_v,
                                      at_w,
                                      sum);
                    }
              }
            else
              for (int q = 0; q < n_points; ++q)
                {
                  Number gradient[3];
                  reference.unit_gradient(q, i, gradient);
                  add_to_diagonal(batches.tangent(b, q), 1, gradient, gradient, sum);
                }
            for (int c = 0; c < 3; ++c)
              store(sum[c], diagonal.of[c][i]);
          }
      }

      /// Add a tangent, tested by two gradients of the same component, to the three components.
      static void
      add_to_diagonal(const float *const tangent,
                      const Number       factor,
                      const Number (&first)[3],
                      const Number (&second)[3],
                      V (&sum)[3])
      {
        for (int c = 0; c < 3; ++c)
          for (int d = 0; d < 3; ++d)
            for (int e = 0; e < 3; ++e)
              sum[c] = hn::MulAdd(load_single_precision<Number>(
                                    tangent + tangent_number(3 * c + d, 3 * c + e) * W),
                                  all(factor * first[d] * second[e]),
                                  sum[c]);
      }

      const Cell           reference;
      const TangentBatches batches;
    };

    // All instruction sets of both files are in one namespace, so that names of templates here must
    // differ from those in cell_kernel.cc.
    template <typename Number, typename Cell>
    std::unique_ptr<CellKernel<Number>>
    make_tangent_kernel_of_shape(const KernelCells &cells)
    {
      // One tangent for each cell is an integral over it; otherwise there is one for each point.
      if (cells.tangents.size() == cells.size())
        return std::make_unique<MeanTangentKernel<Number, Cell>>(cells);
      return std::make_unique<PointTangentKernel<Number, Cell>>(cells);
    }

    template <typename Number>
    std::unique_ptr<CellKernel<Number>>
    make_tangent_kernel_of(const KernelCells &cells)
    {
      constexpr int most = largest_kernel_degree;
      // Gradients in tetrahedra of degree 1 are constant, with one tangent for each cell.
      if (cells.are_tetrahedra && cells.degree == 1)
        return std::make_unique<MeanTangentKernel<Number, CellSimplex<Number, 1>>>(cells);
      if (cells.are_tetrahedra)
        return make_tangent_kernel_of_shape<Number, CellSimplex<Number, most>>(cells);
      if (cells.degree == 1)
        return make_tangent_kernel_of_shape<Number, CellLattice<Number, 1>>(cells);
      return make_tangent_kernel_of_shape<Number, CellLattice<Number, most>>(cells);
    }

    std::unique_ptr<CellKernel<double>>
    make_double_tangents(const KernelCells &cells)
    {
      return make_tangent_kernel_of<double>(cells);
    }

    std::unique_ptr<CellKernel<float>>
    make_float_tangents(const KernelCells &cells)
    {
      return make_tangent_kernel_of<float>(cells);
    }
  } // namespace HWY_NAMESPACE
} // namespace Signorini
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace Signorini
{
  HWY_EXPORT(make_double_tangents);
  HWY_EXPORT(make_float_tangents);



  template <>
  std::unique_ptr<CellKernel<double>>
  make_tangent_kernel(const KernelCells &cells, const std::string &instruction_set)
  {
    const ForcedInstructionSet only(instruction_set);
    return HWY_DYNAMIC_DISPATCH(make_double_tangents)(cells);
  }



  template <>
  std::unique_ptr<CellKernel<float>>
  make_tangent_kernel(const KernelCells &cells, const std::string &instruction_set)
  {
    const ForcedInstructionSet only(instruction_set);
    return HWY_DYNAMIC_DISPATCH(make_float_tangents)(cells);
  }
} // namespace Signorini

#endif
